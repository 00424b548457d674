#include "StraightEnds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "LumenShape.h"
#include "SurfaceEnds.h"

namespace restenosis {
namespace {

/// Moves the cap of an end outwards and joins it to its old rim by new wall.
void carryOn(TriSurface& lumen, const SurfaceEdges& edges, SurfaceRegion end, const Vec3& way) {
  std::unordered_map<std::uint32_t, std::uint32_t> carried;  // a vertex of the cap, and its copy
  const auto copyOf = [&](std::uint32_t vertex) {
    const auto [entry, isNew] =
        carried.try_emplace(vertex, static_cast<std::uint32_t>(lumen.vertices.size()));
    if (isNew) lumen.vertices.push_back(Vec3(lumen.vertices[vertex] + way));
    return entry->second;
  };
  const std::size_t triangles = edges.beyond.size();
  for (std::size_t t = 0; t < triangles; ++t) {
    if (lumen.region[t] != end) continue;
    const auto corners = lumen.triangles[t];
    for (int side = 0; side < 3; ++side) {
      if (lumen.region[edges.beyond[t][side]] == end) continue;
      // Along the rim the new wall runs as the cap did, seen from the old wall
      const std::uint32_t a = corners[side], b = corners[(side + 1) % 3];
      lumen.triangles.push_back({a, b, copyOf(b)});
      lumen.triangles.push_back({a, copyOf(b), copyOf(a)});
      lumen.region.insert(lumen.region.end(), 2, SurfaceRegion::wall);
    }
  }
  for (std::size_t t = 0; t < triangles; ++t)
    if (lumen.region[t] == end)
      for (auto& vertex : lumen.triangles[t]) vertex = copyOf(vertex);
}

/// Whether a place lies in the straight piece beyond an end, whose section fits into a circle of twice the
/// end's radius: elsewhere beyond the plane the lumen itself may pass.
bool beyond(const EndPlane& end, const Vec3& place, double length) {
  const Vec3 from = place - end.centre;
  const double along = from.dot(end.normal);
  const double radius = std::sqrt(end.area / std::numbers::pi);
  return along > 0.0 && along <= 1.01 * length && (from - along * end.normal).norm() < 2.0 * radius;
}

}  // namespace

TriSurface withStraightEnds(const TriSurface& lumen, double length) {
  if (!(length > 0.0)) throw std::invalid_argument("the length of straight ends must be positive");
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  const EndPlane outlet = endPlane(lumen, SurfaceRegion::outlet);
  const SurfaceEdges edges = surfaceEdges(lumen);
  if (!edges.open.empty() || edges.crowded > 0)
    throw std::invalid_argument("the lumen surface is not closed: it cannot be carried on at its ends");
  TriSurface result = lumen;
  carryOn(result, edges, SurfaceRegion::inlet, length * inlet.normal);
  carryOn(result, edges, SurfaceRegion::outlet, length * outlet.normal);
  return result;
}

FlowSolution StraightEnds::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                 const std::filesystem::path& caseFolder) {
  TriSurface longer;
  try {
    longer = withStraightEnds(lumen, length_);
  } catch (const std::invalid_argument& error) {
    throw FlowFailed(error.what(), {});
  }
  FlowSolution solution = backend_->solve(longer, conditions, caseFolder);
  const EndPlane ends[] = {endPlane(lumen, SurfaceRegion::inlet), endPlane(lumen, SurfaceRegion::outlet)};
  std::erase_if(solution.wall, [&](const WallFace& face) {
    return std::ranges::any_of(ends, [&](const EndPlane& end) { return beyond(end, face.centre, length_); });
  });
  return solution;
}

}  // namespace restenosis
