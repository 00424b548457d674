#include "bridge/flow/StraightEnds.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/NearestTriangle.h"
#include "bridge/surface/SurfaceCrossings.h"
#include "bridge/surface/SurfaceEnds.h"
#include "tissue/parameters/LengthUnits.h"

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

/// The sides of the lumen with straight ends, and how many of their triangles are the lumen's own, which come
/// first.
struct Sides {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t own = 0;
};

Sides sidesOf(const TriSurface& longer, std::size_t lumenTriangles) {
  Sides sides;
  for (std::size_t t = 0; t < longer.triangles.size(); ++t) {
    if (isEnd(longer.region[t])) continue;
    sides.triangles.push_back(longer.triangles[t]);
    if (t < lumenTriangles) sides.own = sides.triangles.size();
  }
  return sides;
}

}  // namespace

TriSurface withStraightEnds(const TriSurface& lumen, double length) {
  if (!(length > 0.0)) throw std::invalid_argument("the length of straight ends must be positive");
  std::vector<SurfaceRegion> ends{SurfaceRegion::inlet};
  for (std::size_t n = 0; n < lumen.outletCount(); ++n) ends.push_back(outletRegion(n));
  std::vector<Vec3> ways;
  for (const SurfaceRegion end : ends) ways.push_back(length * endPlane(lumen, end).normal);
  const SurfaceEdges edges = surfaceEdges(lumen);
  if (!edges.open.empty() || edges.crowded > 0)
    throw std::invalid_argument("the lumen surface is not closed: it cannot be carried on at its ends");
  TriSurface result = lumen;
  for (std::size_t n = 0; n < ends.size(); ++n) carryOn(result, edges, ends[n], ways[n]);
  return result;
}

void requireRoomForStraightEnds(const TriSurface& lumen, double length) {
  const TriSurface longer = withStraightEnds(lumen, length);
  const std::vector<std::uint32_t> onePiece(longer.triangles.size(), 0);
  if (const SurfaceCrossings crossings = surfaceCrossings(longer, onePiece); crossings.edges > 0)
    throw std::invalid_argument(
        fmt::format("straight ends of {:.4g} mm run into the lumen or each other, at {}", length / mm,
                    shownPlace(crossings.place)));
}

double longestStraightEnds(const TriSurface& lumen, double length) {
  double longest = 0.0;
  for (int tenths = 1; tenths < 10; ++tenths) try {
      requireRoomForStraightEnds(lumen, 0.1 * tenths * length);
      longest = 0.1 * tenths * length;
    } catch (const std::invalid_argument&) {
      break;
    }
  return longest;
}

FlowSolution StraightEnds::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                 const std::filesystem::path& caseFolder) {
  TriSurface longer;
  try {
    // Whatever lies between the planes of the ends is out of the way of what goes on from them
    if (!frameAlongZ(lumen)) requireRoomForStraightEnds(lumen, length_);
    longer = lumen;
    for (int n = 0; n < rings_; ++n) longer = withStraightEnds(longer, length_ / rings_);
  } catch (const std::invalid_argument& error) {
    throw FlowFailed(error.what(), {});
  }
  FlowSolution solution = wrapped().solve(longer, conditions, caseFolder);
  // By the nearest triangle, not by place: a bent lumen may pass beside its own straight ends
  const Sides sides = sidesOf(longer, lumen.triangles.size());
  const NearestTriangle nearest(longer.vertices, sides.triangles);
  std::erase_if(solution.wall,
                [&](const WallFace& face) { return nearest.at(face.centre).triangle >= sides.own; });
  return solution;
}

}  // namespace restenosis
