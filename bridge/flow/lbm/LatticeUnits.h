#pragma once

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/lbm/LbmSettings.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// What a spacing, a time step and the density stand for.
struct LatticeUnits {
  double dx;                                                             ///< [m]
  double dt;                                                             ///< [s]
  double density;                                                        ///< [kg/m^3]
  double velocity() const { return dx / dt; }                            ///< [m/s]
  double pressure() const { return density * velocity() * velocity(); }  ///< [Pa]
  double flowRate() const { return dx * dx * dx / dt; }                  ///< [m^3/s]
  double relaxationTime(double kinematicViscosity) const {
    return 0.5 + 3.0 * kinematicViscosity * dt / (dx * dx);
  }
};

/// What can be said of a flow before solving it, from Poiseuille's law in every cross-section. Of a lumen
/// that does not lie along z it knows its ends and its volume only, and starts it at rest.
class FlowEstimate {
 public:
  /// Throws std::invalid_argument where the lumen is closed.
  FlowEstimate(const TriSurface& lumen, const FlowConditions& conditions, int stations = 400);
  double flowRate() const { return flowRate_; }  ///< [m^3/s]
  double peakVelocity() const { return peak_; }  ///< on the axis of the narrowest cross-section [m/s]
  /// Pressure above that of the outlet [Pa], and velocity along the axis [m/s], at a point.
  double pressure(const Vec3& position) const;
  double velocity(const Vec3& position) const;
  double length() const { return length_; }  ///< along the lumen [m]

 private:
  void fromEnds(const TriSurface& lumen, const FlowConditions& conditions);
  bool knowsEndsOnly() const { return area_.empty(); }
  std::size_t station(double z) const;

  Vec3 centre_ = Vec3::Zero();
  double first_ = 0.0, spacing_ = 0.0, length_ = 0.0, flowRate_ = 0.0, peak_ = 0.0;
  std::vector<double> area_, pressure_;
};

/// Time step such that the estimated peak velocity is `latticeVelocity` spacings per step, or smaller where
/// the relaxation time would exceed 2, where the wall's error grows.
LatticeUnits latticeUnits(double dx, const FlowEstimate& estimate, const FlowConditions& conditions,
                          double latticeVelocity);

}  // namespace restenosis
