#pragma once

#include <array>
#include <string>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Developed flow through an inlet of any shape.
///
/// In developed flow the Laplacian of the velocity is constant and the velocity on the rim is 0. With places
/// x + i y = r exp(i t) in the inlet's plane, over the radius of the circle of its area,
///
///     w(x, y) = c - r^2 + sum_{k=1..order} r^k (a_k cos kt + b_k sin kt)
///                     + sum_h d_h ln |z - z_h| + Re (e_h / (z - z_h))
///
/// with z = x + i y and the middles z_h of the inlet's holes fulfils the first for any coefficients; they are
/// those of the least squares of w on the rims (Trefftz's method). A circle gives the paraboloid, an ellipse
/// is met exactly by k = 2, an annulus by its logarithm. The error is harmonic, so it is nowhere larger than
/// the largest w left on the rims.
struct InletProfile {
  /// What stands in the way within the inlet.
  struct Hole {
    double x, y;                           ///< middle, in radii from the centre
    std::array<double, 3> coefficients{};  ///< d_h, and the real and the imaginary part of e_h
  };
  static constexpr std::size_t order = 8;  ///< assumed: rims of lumens are smooth
  Vec3 centre;                             ///< of the inlet [m]
  Vec3 inside;                             ///< a place well inside it [m]; the centre, unless it is none
  Vec3 direction;                          ///< of the flow, a unit vector
  Vec3 xAxis, yAxis;    ///< of the plane, unit vectors; x and y themselves for flow along z
  double radius = 0.0;  ///< of the circle of the inlet's area [m]
  double constant = 1.0;
  std::array<double, order> cosine{}, sine{};  ///< a_k and b_k
  std::vector<Hole> holes;
  double rimError = 0.0;  ///< largest |w| on the rims, over w well inside

  /// w at a place in the inlet's plane, in radii from the centre.
  double operator()(double x, double y) const;
  /// w well inside the inlet, about its largest.
  double peak() const;
  /// w in OpenFOAM's expressions, of the variables r2 = r^2, c<k> = r^k cos kt and s<k> = r^k sin kt.
  std::string expression() const;
};

/// The profile of a lumen's inlet. Throws std::invalid_argument where the lumen has no planar inlet.
InletProfile developedProfile(const TriSurface& lumen);

}  // namespace restenosis
