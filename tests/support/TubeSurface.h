#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis::support {

/// A point of a profile r(z) and what the piece from it to the next point belongs to.
struct ProfilePoint {
  double radius, z;  ///< [m]
  SurfaceRegion region = SurfaceRegion::wall;
};

/// The closed surface swept by a profile about the z axis, from inlet to outlet. Radii are enlarged so that
/// each cross-section, a polygon, has the area of the circle.
inline TriSurface revolve(const std::vector<ProfilePoint>& profile, std::uint32_t sides = 128) {
  TriSurface s;
  const double step = 2.0 * std::numbers::pi / sides;
  const double equalArea = std::sqrt(step / std::sin(step));
  for (const auto& p : profile)
    for (std::uint32_t i = 0; i < sides; ++i)
      s.vertices.push_back(
          {equalArea * p.radius * std::cos(i * step), equalArea * p.radius * std::sin(i * step), p.z});
  const auto add = [&s](std::uint32_t a, std::uint32_t b, std::uint32_t c, SurfaceRegion region) {
    s.triangles.push_back({a, b, c});
    s.region.push_back(region);
  };
  for (std::uint32_t k = 0; k + 1 < profile.size(); ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      add(a, b, b + sides, profile[k].region);
      add(a, b + sides, a + sides, profile[k].region);
    }
  const auto centre = static_cast<std::uint32_t>(s.vertices.size());
  const std::uint32_t last = centre - sides;
  s.vertices.push_back({0, 0, profile.front().z});
  s.vertices.push_back({0, 0, profile.back().z});
  for (std::uint32_t i = 0; i < sides; ++i) {
    add(centre, (i + 1) % sides, i, SurfaceRegion::inlet);
    add(centre + 1, last + i, last + (i + 1) % sides, SurfaceRegion::outlet);
  }
  return s;
}

/// A straight tube [m].
inline TriSurface tube(double radius, double length, int pieces = 12) {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= pieces; ++i) profile.push_back({radius, length * i / pieces});
  return revolve(profile);
}

/// A tube with a square ring of size `strut` half way along [m], whose faces are cut into so many pieces.
inline TriSurface stentedTube(double radius, double length, double strut, int pieces = 1) {
  const double a = 0.5 * (length - strut), b = 0.5 * (length + strut);
  std::vector<ProfilePoint> profile;
  for (int i = 0; i < 6; ++i) profile.push_back({radius, a * i / 6});
  const double piece = strut / pieces;
  for (int i = 0; i < pieces; ++i) profile.push_back({radius - i * piece, a, SurfaceRegion::strut});
  for (int i = 0; i < pieces; ++i) profile.push_back({radius - strut, a + i * piece, SurfaceRegion::strut});
  for (int i = 0; i < pieces; ++i) profile.push_back({radius - strut + i * piece, b, SurfaceRegion::strut});
  for (int i = 0; i <= 6; ++i) profile.push_back({radius, b + (length - b) * i / 6});
  return revolve(profile);
}

}  // namespace restenosis::support
