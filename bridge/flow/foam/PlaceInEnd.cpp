#include "bridge/flow/foam/PlaceInEnd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bridge/flow/LumenShape.h"

namespace restenosis {
namespace {

/// Least distance of a place from the rim, over the radius of the circle of the end's area (assumed).
constexpr double wellInside = 0.2;

/// Whether a place in the triangle's plane lies in the triangle.
bool contains(const TriSurface& lumen, std::size_t triangle, const Vec3& place) {
  const auto& t = lumen.triangles[triangle];
  const Vec3 normal = lumen.areaVector(triangle);
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = lumen.vertices[t[k]], &b = lumen.vertices[t[(k + 1) % 3]];
    if ((b - a).cross(place - a).dot(normal) < 0.0) return false;
  }
  return true;
}

double distanceFromEdge(const Vec3& place, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double share = std::clamp((place - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (place - a - share * edge).norm();
}

}  // namespace

Vec3 placeInEnd(const TriSurface& lumen, SurfaceRegion end) {
  const EndPlane plane = endPlane(lumen, end);
  const auto rim = endRim(lumen, end);
  const auto fromRim = [&](const Vec3& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : rim)
      nearest = std::min(nearest, distanceFromEdge(place, lumen.vertices[a], lumen.vertices[b]));
    return nearest;
  };
  bool centreInside = false;
  for (std::size_t t = 0; t < lumen.triangles.size() && !centreInside; ++t)
    centreInside = lumen.region[t] == end && contains(lumen, t, plane.centre);
  if (centreInside && fromRim(plane.centre) > wellInside * std::sqrt(plane.area / std::numbers::pi))
    return plane.centre;

  Vec3 best = plane.centre;
  double farthest = centreInside ? fromRim(best) : 0.0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != end) continue;
    const Vec3 place = lumen.centre(t);
    if (const double distance = fromRim(place); distance > farthest) farthest = distance, best = place;
  }
  return best;
}

}  // namespace restenosis
