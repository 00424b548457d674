#pragma once

#include <cmath>
#include <numbers>

#include "FlowSupport.h"
#include "LatticeSupport.h"
#include "LbmBackend.h"

namespace restenosis::testing {

/// Blood at a mean velocity of 1 mm/s: Re = 0.4 in a tube of 1 mm, so that entrance effects die out within a
/// diameter.
inline FlowConditions slowConditions(double area) {
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = 1e-3 * area;
  return conditions;
}

/// Stress in the middle tenth of a tube turned by an angle from the lattice, solved with open ends, which are
/// cut along the lattice, against Poiseuille's.
inline StressError turnedTubeError(double degrees, int nodesAcross, const char* wall = "interpolated",
                                   const char* stress = "fitted") {
  const double angle = degrees * std::numbers::pi / 180.0, radius = 0.5e-3, length = 3e-3;
  // Through the ends, cut obliquely, flows what flows along the axis
  const FlowConditions conditions = slowConditions(std::numbers::pi * radius * radius);
  LbmSettings settings;
  settings.dx = 2.0 * radius / nodesAcross;
  settings.wall = wall;
  settings.stress = stress;
  LbmBackend backend(settings);
  const auto s = backend.solve(turnedTube(radius, length, angle), conditions, {});
  return stressError(s, 4.0 * conditions.dynamicViscosity() * 1e-3 / radius, 0.45 * length, 0.55 * length);
}

/// Departures from the developed flow in an ellipse of half axes 0.5 and 0.3 mm, turned by 25 degrees, in all
/// of a duct 0.6 mm long.
struct EllipticError {
  StressError stress;   ///< relative to the largest stress
  double pressureDrop;  ///< relative
  double velocity;      ///< rms over points in the cross-section half way, relative to the peak
};
inline EllipticError ellipticDuctError(int nodesAcross) {
  const double length = 0.6e-3;
  EllipticFlow exact{0.5e-3, 0.3e-3, 25.0 * std::numbers::pi / 180.0, 0.0, 0.0};
  const FlowConditions conditions = slowConditions(std::numbers::pi * exact.a * exact.b);
  exact.peak = 2e-3;
  exact.dynamicViscosity = conditions.dynamicViscosity();
  LbmSettings settings;
  settings.dx = 2.0 * exact.a / nodesAcross;
  LbmBackend backend(settings, nullptr, true);
  const auto s = backend.solve(ellipticDuct(exact.a, exact.b, length, exact.angle), conditions, {});
  const double largest =
      exact.stress(Vec3(-std::sin(exact.angle) * exact.b, std::cos(exact.angle) * exact.b, 0));
  EllipticError e{};
  e.stress = stressError(
      s, [&](const Vec3& p) { return exact.stress(p); }, largest, 0.0, length);
  e.pressureDrop = s.pressureDrop / (exact.pressureGradient() * length) - 1.0;
  std::vector<Vec3> points;
  for (int i = -9; i <= 9; ++i)
    for (int j = -9; j <= 9; ++j) {
      const Vec3 p(0.05e-3 * i, 0.05e-3 * j, 0.5 * length);
      if (exact.velocity(p) > 0.3 * exact.peak) points.push_back(p);
    }
  const auto found = backend.velocities(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    e.velocity += (found[i] - Vec3(0.0, 0.0, exact.velocity(points[i]))).squaredNorm();
  e.velocity = std::sqrt(e.velocity / static_cast<double>(points.size())) / exact.peak;
  return e;
}

}  // namespace restenosis::testing
