#pragma once

#include <cmath>
#include <numbers>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Coordinates about the vessel's axis: distance from the axis, angle, and place along it.
struct Cylindrical {
  double radius;  ///< [m]
  double angle;   ///< (-pi, pi]
  double z;       ///< [m]
};

inline Cylindrical toCylindrical(const Vec3& p) {
  return {std::hypot(p.x(), p.y()), std::atan2(p.y(), p.x()), p.z()};
}

inline Vec3 toCartesian(const Cylindrical& c) {
  return {c.radius * std::cos(c.angle), c.radius * std::sin(c.angle), c.z};
}

inline double radiusOf(const Vec3& p) { return std::hypot(p.x(), p.y()); }

/// Unit vector away from the axis; x where the point lies on the axis.
inline Vec3 radialAt(const Vec3& p) {
  const double radius = radiusOf(p);
  return radius > 0 ? Vec3(p.x() / radius, p.y() / radius, 0) : Vec3::UnitX();
}

/// The point moved along its radius to the distance `radius` from the axis.
inline Vec3 atRadius(const Vec3& p, double radius) {
  const Vec3 out = radialAt(p);
  return {radius * out.x(), radius * out.y(), p.z()};
}

}  // namespace restenosis
