#pragma once

#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/ViscosityLaw.h"

namespace restenosis {

/// Developed flow of blood that thins, through a circular tube.
///
/// The stress grows from the axis to the wall as the radius does, t = t_w r / R, so that with t(g) = nu(g) g
///
///     Q = pi R^3 / 3 (g_w - t_w^-3 int_0^g_w t^3 dg)                     (Rabinowitsch, by parts)
///     u(r) = R / t_w int_t(r)^t_w g dt
class TubeFlow {
 public:
  /// `flowRate` [m^3/s] and `radius` [m] are positive.
  static TubeFlow ofFlowRate(const ViscosityLaw& law, double flowRate, double radius);
  /// `stress`: at the wall, over the density [m^2/s^2].
  static TubeFlow ofWallStress(const ViscosityLaw& law, double stress, double radius);

  /// At the wall [1/s].
  double wallShearRate() const { return rates_.back(); }
  /// At the wall, over the density [m^2/s^2].
  double wallStress() const { return stresses_.back(); }
  double flowRate() const { return flowRate_; }
  /// At a distance from the axis [m/s].
  double velocity(double r) const;

 private:
  TubeFlow(const ViscosityLaw& law, double wallShearRate, double radius);

  double radius_, flowRate_;
  std::vector<double> rates_, stresses_, velocities_;  ///< from the axis to the wall
};

/// The stress at the wall of a tube in developed flow [Pa]: 4 mu Q / (pi R^3) of a Newtonian fluid.
double developedWallStress(const FlowConditions& conditions, double flowRate, double radius);

/// The pressure gradient of developed flow [Pa/m] through a cross-section of this area [m^2], as in a circle.
double developedGradient(const FlowConditions& conditions, double flowRate, double area);

}  // namespace restenosis
