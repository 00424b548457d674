#pragma once

#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/surface/RadialMap.h"

namespace restenosis {

/// How wall shear stress answers to a small movement of the wall, to first order in the movement.
///
/// Near a wall the flow is a simple shear in which viscosity rules, as long as the movement's waves are short
/// against the vessel and shear * wavelength^2 / (40 nu) is below about one. A wall raised into it by
///   h = (R before - R after) = sum over k of h_k exp(i k x),  k = (along the flow, around the vessel),
/// must bring the fluid to rest where it had the velocity shear * h; the Stokes flow in a half-space that
/// does so changes the shear by
///   d(tau) / tau = sum over k of (|k| + k_along^2 / |k|) h_k exp(i k x).
/// Crests feel more, hollows less. The mean movement (k = 0) changes it as in a tube: by 3 h / R at a given
/// flow rate, by -h / R at a given pressure gradient. Waves shorter than the cut-off are smoothed by a
/// Gaussian of that width: no flow mesh resolves them. Movements are mirrored at the ends.
class ShearResponse {
 public:
  /// Throws std::invalid_argument for maps on different planes, or with fewer than two.
  ShearResponse(const RadialMap& before, const RadialMap& after, FlowConditions::Drive drive, double cutoff);

  /// Stress after the movement over that before it, at the axial position and angle of a point. With the
  /// first-order change x it is 1 + x, or 1 / (1 - x) where x < 0, which is the same to first order and stays
  /// positive.
  double factorAt(const Vec3& point) const;

 private:
  RadialMap map_;               ///< for its planes and angles
  std::vector<double> change_;  ///< d(tau) / tau by plane and angle
};

}  // namespace restenosis
