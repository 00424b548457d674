#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis::support {

/// Appends a piece of vertices and quadrilaterals, each in the order of its outward normal, to a surface.
inline void append(TriSurface& s, const std::vector<Vec3>& vertices,
                   const std::vector<std::array<std::uint32_t, 4>>& sides) {
  const auto first = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.insert(s.vertices.end(), vertices.begin(), vertices.end());
  for (const auto& [a, b, c, d] : sides) {
    s.triangles.push_back({first + a, first + b, first + c});
    s.triangles.push_back({first + a, first + c, first + d});
  }
  s.region.resize(s.triangles.size(), SurfaceRegion::strut);
}

/// A box with its edges along the axes, from one corner to the opposite one [m]: two triangles a face.
inline TriSurface box(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (int n = 0; n < 8; ++n)
    corners.emplace_back(n & 1 ? high.x() : low.x(), n & 2 ? high.y() : low.y(), n & 4 ? high.z() : low.z());
  TriSurface s;
  append(s, corners, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  return s;
}

/// A ring about the z axis, swept by a convex section of points (radius, z) [m] that runs anticlockwise where
/// the radius points right and z upwards.
inline TriSurface ring(const std::vector<std::pair<double, double>>& section, std::uint32_t sides) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  const auto corners = static_cast<std::uint32_t>(section.size());
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const auto& [radius, z] : section)
      vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    for (std::uint32_t k = 0; k < corners; ++k) {
      const std::uint32_t a = i * corners, b = (i + 1) % sides * corners, next = (k + 1) % corners;
      faces.push_back({a + k, b + k, b + next, a + next});
    }
  }
  TriSurface s;
  append(s, vertices, faces);
  return s;
}

/// A ring of square section, half way along a vessel [m].
inline TriSurface squareRing(double outerRadius, double strut, double vesselLength,
                             std::uint32_t sides = 200) {
  const double inner = outerRadius - strut, low = (vesselLength - strut) / 2, high = low + strut;
  return ring({{inner, low}, {outerRadius, low}, {outerRadius, high}, {inner, high}}, sides);
}

/// A torus about the z axis, of a wire's radius and that of its centreline [m].
inline TriSurface torus(double centreline, double wire, double z, std::uint32_t sides = 200) {
  std::vector<std::pair<double, double>> section;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * std::numbers::pi * k / 24;
    section.emplace_back(centreline + wire * std::cos(angle), z + wire * std::sin(angle));
  }
  return ring(section, sides);
}

/// Both surfaces, as pieces of one.
inline TriSurface together(TriSurface a, const TriSurface& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  a.region.insert(a.region.end(), b.region.begin(), b.region.end());
  return a;
}

/// The same surface with its normals reversed.
inline TriSurface insideOut(TriSurface s) {
  for (auto& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

}  // namespace restenosis::support
