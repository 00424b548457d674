#include "bridge/surface/SurfaceCrossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/TriangleBoxes.h"

namespace restenosis {
namespace {

/// How far vertices of a file may be from their places: what they are made one by, over the diagonal of the
/// surface's box, and the rounding of single precision, over the largest coordinate; each with a factor of
/// about 4 (assumed).
constexpr double merged = 4e-6, rounded = 0x1p-22;
/// Where an edge meets a side of the triangle, over the tolerance: how near to it, and how far from their
/// ends. Sides cross there only where the surface does: what rounding shifts over a side has an end near it,
/// or runs nearly along it (assumed).
constexpr double meets = 1e-3, clearly = 100;

double toleranceOf(const TriSurface& s) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : s.vertices) box.extend(v);
  return merged * box.diagonal().norm() +
         rounded * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// Where the segment from p to q goes through a triangle, if it does so by more than the tolerance.
std::optional<Vec3> passage(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& corners,
                            double tolerance) {
  const Vec3 areaVector = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double doubleArea = areaVector.norm();
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).norm());
  if (doubleArea <= tolerance * longest) return {};  // so flat that rounding turns its plane
  const Vec3 normal = areaVector / doubleArea;
  const double before = normal.dot(p - corners[0]), behind = normal.dot(q - corners[0]);
  if (std::min(std::abs(before), std::abs(behind)) <= tolerance || (before < 0) == (behind < 0)) return {};
  const Vec3 place = p + before / (before - behind) * (q - p);
  double within = HUGE_VAL, fromCorner = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const Vec3 side = corners[(k + 1) % 3] - corners[k], there = place - corners[k];
    within = std::min(within, normal.dot(side.cross(there)) / side.norm());
    fromCorner = std::min(fromCorner, there.norm());
  }
  if (within > tolerance) return place;
  const bool edgesCross = within > -meets * tolerance &&
                          std::min({std::abs(before), std::abs(behind), fromCorner}) > clearly * tolerance;
  return edgesCross ? std::optional(place) : std::nullopt;
}

}  // namespace

SurfaceCrossings surfaceCrossings(const TriSurface& s, const std::vector<std::uint32_t>& pieceOf) {
  if (s.triangles.empty()) return {};
  const double tolerance = toleranceOf(s);
  const SurfaceEdges edges = surfaceEdges(s);
  const TriangleBoxes boxes(s, tolerance);

  const auto passageOf = [&](std::size_t triangle, int side) {
    const std::uint32_t from = s.triangles[triangle][side], to = s.triangles[triangle][(side + 1) % 3];
    std::optional<Vec3> found;
    boxes.along(s.vertices[from], s.vertices[to], [&](std::uint32_t other) {
      const auto& t = s.triangles[other];
      if (found || pieceOf[other] != pieceOf[triangle]) return;
      if (std::ranges::any_of(t, [&](auto v) { return v == from || v == to; })) return;
      found = passage(s.vertices[from], s.vertices[to],
                      {s.vertices[t[0]], s.vertices[t[1]], s.vertices[t[2]]}, tolerance);
    });
    return found;
  };
  std::vector<SurfaceCrossings> ofTriangle(s.triangles.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      if (edges.beyond[t][side] < t) continue;  // the edge is that triangle's
      if (const auto place = passageOf(t, side))
        if (ofTriangle[t].edges++ == 0) ofTriangle[t].place = *place;
    }
  SurfaceCrossings all;
  for (const SurfaceCrossings& one : ofTriangle) {
    if (all.edges == 0) all.place = one.place;
    all.edges += one.edges;
  }
  return all;
}

}  // namespace restenosis
