#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// What a face of the lumen surface belongs to. Of several outlets the first is `outlet`, and the others
/// follow it (outletRegion).
enum class SurfaceRegion : std::uint8_t { wall, strut, inlet, outlet };

constexpr bool isOutlet(SurfaceRegion region) { return region >= SurfaceRegion::outlet; }
constexpr bool isEnd(SurfaceRegion region) { return region >= SurfaceRegion::inlet; }
/// The n-th outlet, from 0.
constexpr SurfaceRegion outletRegion(std::size_t n) {
  return static_cast<SurfaceRegion>(static_cast<std::size_t>(SurfaceRegion::outlet) + n);
}
/// Most outlets of a lumen.
inline constexpr std::size_t mostOutlets = 64;

/// A closed triangulated lumen surface [m]. Normals (right-hand rule) point out of the lumen, into the wall.
/// The ends are planar and carry the regions inlet and outlet; there is one inlet.
struct TriSurface {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<SurfaceRegion> region;  ///< one a triangle

  /// Normal times area of a triangle [m^2].
  Vec3 areaVector(std::size_t triangle) const {
    const auto& t = triangles[triangle];
    return 0.5 * (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
  }
  Vec3 centre(std::size_t triangle) const {
    const auto& t = triangles[triangle];
    return (vertices[t[0]] + vertices[t[1]] + vertices[t[2]]) / 3.0;
  }
  /// One, as a rule.
  std::size_t outletCount() const {
    const auto last = std::max_element(region.begin(), region.end());
    if (last == region.end() || !isOutlet(*last)) return 0;
    return static_cast<std::size_t>(*last) - static_cast<std::size_t>(SurfaceRegion::outlet) + 1;
  }

  template <class Archive>
  void archive(Archive& a) {
    std::vector<std::array<double, 3>> places(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
      places[v] = {vertices[v].x(), vertices[v].y(), vertices[v].z()};
    a(places, triangles, region);
    vertices.resize(places.size());
    for (std::size_t v = 0; v < places.size(); ++v) vertices[v] = {places[v][0], places[v][1], places[v][2]};
  }
};

/// Volume enclosed by a closed surface with outward normals [m^3]: the divergence theorem about the first
/// vertex, which keeps the cancellation small far from the origin.
inline double enclosedVolume(const TriSurface& surface) {
  const Vec3 origin = surface.vertices.front();
  double volume = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    volume += (surface.vertices[surface.triangles[t][0]] - origin).dot(surface.areaVector(t)) / 3.0;
  return volume;
}

}  // namespace restenosis
