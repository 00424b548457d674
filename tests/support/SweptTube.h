#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "bridge/surface/Rotation.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis::support {

/// A place on the axis of a tube and the direction of the axis there.
struct AxisPoint {
  Vec3 place, direction;  ///< [m], unit vector
};

/// The closed tube of circular cross-section along an axis in the plane of x and z. Cross-sections are
/// polygons of the circle's area.
inline TriSurface sweptTube(const std::vector<AxisPoint>& axis, double radius, std::uint32_t sides = 96) {
  TriSurface s;
  const double step = 2.0 * std::numbers::pi / sides;
  const double corner = radius * std::sqrt(step / std::sin(step));
  for (const AxisPoint& p : axis) {
    const Vec3 across = Vec3::UnitY().cross(p.direction);
    for (std::uint32_t i = 0; i < sides; ++i)
      s.vertices.push_back(p.place +
                           corner * (std::cos(i * step) * across + std::sin(i * step) * Vec3::UnitY()));
  }
  const auto add = [&s](std::uint32_t a, std::uint32_t b, std::uint32_t c, SurfaceRegion region) {
    s.triangles.push_back({a, b, c});
    s.region.push_back(region);
  };
  for (std::uint32_t k = 0; k + 1 < axis.size(); ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      add(a, b, b + sides, SurfaceRegion::wall);
      add(a, b + sides, a + sides, SurfaceRegion::wall);
    }
  const auto centre = static_cast<std::uint32_t>(s.vertices.size());
  const std::uint32_t last = centre - sides;
  s.vertices.push_back(axis.front().place);
  s.vertices.push_back(axis.back().place);
  for (std::uint32_t i = 0; i < sides; ++i) {
    add(centre, (i + 1) % sides, i, SurfaceRegion::inlet);
    add(centre + 1, last + i, last + (i + 1) % sides, SurfaceRegion::outlet);
  }
  return s;
}

/// A tube that runs along z from the origin for `before`, turns by 90 degrees towards x about an arc of
/// radius `bend`, and runs along x for `after` [m].
inline TriSurface bentTube(double radius, double before, double bend, double after) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  constexpr int arcPieces = 24, straightPieces = 8;
  std::vector<AxisPoint> axis;
  for (int i = 0; i < straightPieces; ++i)
    axis.push_back({Vec3(0, 0, before * i / straightPieces), Vec3::UnitZ()});
  for (int i = 0; i <= arcPieces; ++i) {
    const double turn = quarter * i / arcPieces;
    axis.push_back({Vec3(bend * (1 - std::cos(turn)), 0, before + bend * std::sin(turn)),
                    Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  for (int i = 1; i <= straightPieces; ++i)
    axis.push_back({Vec3(bend + after * i / straightPieces, 0, before + bend), Vec3::UnitX()});
  return sweptTube(axis, radius);
}

/// The surface after a rigid motion.
inline TriSurface moved(TriSurface surface, const Eigen::Isometry3d& motion) {
  for (Vec3& v : surface.vertices) v = motion * v;
  return surface;
}

/// The motion that turns z into a direction and the origin into a place [m].
inline Eigen::Isometry3d motionTo(const Vec3& direction, const Vec3& place) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = rotationOnto(Vec3::UnitZ(), direction);
  motion.translation() = place;
  return motion;
}

}  // namespace restenosis::support
