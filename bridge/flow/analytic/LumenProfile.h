#pragma once

#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A lumen between two planes of constant z as a tube of varying radius about the line through the centroids
/// of its cross-sections, which need not run along z: the ends may be cut obliquely. At each of the
/// cross-sections, evenly spaced in z, the axis points along the chord of that line over one diameter, so
/// that roughness does not turn it, and the radius is that of a circle with the area of the lumen across the
/// axis: the area in the plane of constant z times the axis' component along z.
class LumenProfile {
 public:
  /// @param stations number of cross-sections; > 1
  /// Throws FlowFailed where the lumen is closed, std::invalid_argument where an end is no plane of constant
  /// z.
  LumenProfile(const TriSurface& lumen, int stations);

  /// The tube where a plane of constant z cuts it.
  struct Place {
    double radius;  ///< across the axis [m]
    Vec3 axis;      ///< towards the outlet; of unit length but for the rounding of interpolation
  };
  /// Interpolated linearly between cross-sections; `z` in m.
  Place at(double z) const;

  double meanRadius() const;
  /// Distance between the planes of the ends [m].
  double length() const { return spacing_ * static_cast<double>(places_.size()); }
  /// Pressure lost along the lumen for a unit flow rate [Pa s/m^3], by Poiseuille's law in every
  /// cross-section.
  double resistance(double dynamicViscosity) const;

 private:
  double first_ = 0.0, spacing_ = 0.0;
  std::vector<Place> places_;
};

}  // namespace restenosis
