#pragma once

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis::support {

/// Blood at a mean velocity of 1 mm/s: Re = 0.4 in a tube of 1 mm, so that entrance effects die out within a
/// diameter.
inline FlowConditions slowConditions(double area) {
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = 1e-3 * area;
  return conditions;
}

/// A straight duct whose cross-section is an ellipse with these half axes, its first axis turned by `angle`
/// from x about z [m].
inline TriSurface ellipticDuct(double a, double b, double length, double angle, std::uint32_t sides = 256) {
  constexpr int pieces = 40;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= pieces; ++i) profile.push_back({1.0, length * i / pieces});
  TriSurface s = revolve(profile, sides);
  const Eigen::Rotation2Dd turn(angle);
  for (Vec3& v : s.vertices) v.head<2>() = turn * Eigen::Vector2d(a * v.x(), b * v.y());
  return s;
}

/// Developed flow in that duct: u = peak (1 - (x/a)^2 - (y/b)^2), with the flow rate pi a b peak / 2.
struct EllipticFlow {
  double a = 0.5e-3, b = 0.3e-3, angle = 25.0 * std::numbers::pi / 180.0, peak = 2e-3,
         dynamicViscosity = 2.7e-3;
  Eigen::Vector2d inAxes(const Vec3& p) const { return Eigen::Rotation2Dd(-angle) * p.head<2>(); }
  double velocity(const Vec3& p) const {
    const Eigen::Vector2d q = inAxes(p);
    return peak * (1.0 - q.x() * q.x() / (a * a) - q.y() * q.y() / (b * b));
  }
  /// Stress on the wall at a point of it [Pa].
  double stress(const Vec3& p) const {
    const Eigen::Vector2d q = inAxes(p);
    return 2.0 * dynamicViscosity * peak * std::hypot(q.x() / (a * a), q.y() / (b * b));
  }
  double pressureGradient() const { return 2.0 * dynamicViscosity * peak * (1.0 / (a * a) + 1.0 / (b * b)); }
};

/// Departures from the developed flow in an ellipse of half axes 0.5 and 0.3 mm, turned by 25 degrees, in a
/// duct 0.6 mm long but for a margin at either end.
struct EllipticError {
  StressError stress;   ///< relative to the largest stress
  double pressureDrop;  ///< relative
  double velocity;      ///< rms over points in the cross-section half way, relative to the peak
};
inline EllipticError ellipticDuctError(FlowBackend& backend, const std::filesystem::path& folder,
                                       double endMargin = 0.0) {
  const double length = 0.6e-3;
  const EllipticFlow exact;
  const FlowConditions conditions = slowConditions(std::numbers::pi * exact.a * exact.b);
  const auto s = backend.solve(ellipticDuct(exact.a, exact.b, length, exact.angle), conditions, folder);
  const double largest =
      exact.stress(Vec3(-std::sin(exact.angle) * exact.b, std::cos(exact.angle) * exact.b, 0));
  EllipticError e{};
  e.stress = stressError(
      s, [&](const Vec3& p) { return exact.stress(p); }, largest, endMargin, length - endMargin);
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

}  // namespace restenosis::support
