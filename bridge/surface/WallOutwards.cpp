#include "bridge/surface/WallOutwards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/NearestTriangle.h"
#include "tissue/agents/Chunks.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using std::numbers::pi;

/// Where two crossings of one ray are nearer than this share of the grid's spacing, they are the same wall
/// (assumed): rough surfaces have small folds.
constexpr double samePlace = 0.1;

bool isSide(SurfaceRegion region) { return region == SurfaceRegion::wall || region == SurfaceRegion::strut; }

/// The rays of a RadiusMap: from the axis, at equal angles in planes of constant z.
struct RayGrid {
  int around, along;
  double zLow, zStep;

  RayGrid(const TriSurface& lumen, double spacing) {
    double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0;
    for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
      if (!isSide(lumen.region[t])) continue;
      for (const auto v : lumen.triangles[t]) {
        const Vec3& p = lumen.vertices[v];
        low = std::min(low, p.z()), high = std::max(high, p.z()), widest = std::max(widest, radiusOf(p));
      }
    }
    const double inset = 1e-6 * (high - low);  // so that every plane cuts the side and none only its rim
    around = std::max(16, static_cast<int>(std::ceil(2 * pi * widest / spacing)));
    along = 2 + static_cast<int>(std::ceil((high - low) / spacing));
    zLow = low + inset;
    zStep = (high - low - 2 * inset) / (along - 1);
  }

  std::size_t size() const { return static_cast<std::size_t>(around) * along; }
  double angleStep() const { return 2 * pi / around; }
  double angle(int k) const { return (static_cast<double>(k) / around - 0.5) * 2 * pi; }
  double z(int row) const { return zLow + row * zStep; }
  Vec3 place(std::size_t node, double radius) const {
    return toCartesian({radius, angle(static_cast<int>(node) % around), z(static_cast<int>(node) / around)});
  }
  /// Area of the node's share of the cylinder of radius 1 m.
  double share(std::size_t node) const {
    const int row = static_cast<int>(node) / around;
    return angleStep() * zStep * (row == 0 || row + 1 == along ? 0.5 : 1.0);
  }
  RadiusMap map(std::vector<double> radii) const { return {around, zLow, zStep, std::move(radii)}; }
};

/// Nearest and farthest crossing of a ray with the lumen's side.
struct Crossings {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
};

/// Notes what the rays of one plane meet of the edge, from p to q, in which a triangle cuts the plane.
void meet(const RayGrid& grid, int row, const Vec3& p, const Vec3& q, std::vector<Crossings>& crossings) {
  constexpr double rounding = 1e-9;
  const double from = std::atan2(p.y(), p.x());
  const double turn = std::remainder(std::atan2(q.y(), q.x()) - from, 2 * pi);
  const double low = std::min(from, from + turn), high = std::max(from, from + turn);
  const auto nodeOf = [&](double angle) { return (angle / (2 * pi) + 0.5) * grid.around; };
  for (int k = static_cast<int>(std::ceil(nodeOf(low) - rounding)); k <= nodeOf(high) + rounding; ++k) {
    const Vec3 out(std::cos(grid.angle(k)), std::sin(grid.angle(k)), 0);
    const double before = out.cross(p).z(), behind = out.cross(q).z();
    // On the edge itself: one as short as round-off, where a plane passes a corner, has any direction
    const double share = before != behind ? std::clamp(before / (before - behind), 0.0, 1.0) : 0.0;
    const double radius = out.dot(p + share * (q - p));
    if (!(radius > 0)) continue;
    const int node = ((k % grid.around) + grid.around) % grid.around;
    Crossings& ray = crossings[static_cast<std::size_t>(row) * grid.around + node];
    ray.nearest = std::min(ray.nearest, radius), ray.farthest = std::max(ray.farthest, radius);
  }
}

std::vector<Crossings> crossingsOf(const TriSurface& lumen, const RayGrid& grid) {
  std::vector<Crossings> crossings(grid.size());
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (!isSide(lumen.region[t])) continue;
    const auto corner = [&](int k) -> const Vec3& { return lumen.vertices[lumen.triangles[t][k % 3]]; };
    const auto [low, high] = std::minmax({corner(0).z(), corner(1).z(), corner(2).z()});
    const int first = std::max(0, static_cast<int>(std::ceil((low - grid.zLow) / grid.zStep)));
    for (int row = first; row < grid.along && grid.z(row) <= high; ++row) {
      const double z = grid.z(row);
      std::vector<Vec3> cut;
      for (int k = 0; k < 3; ++k) {
        const Vec3 &a = corner(k), &b = corner(k + 1);
        // A corner in the plane counts as above it
        if ((a.z() >= z) != (b.z() >= z)) cut.emplace_back(a + (z - a.z()) / (b.z() - a.z()) * (b - a));
      }
      if (cut.size() == 2) meet(grid, row, cut[0], cut[1], crossings);
    }
  }
  return crossings;
}

/// Of each ray of the grid how far from the axis it meets the lumen's side [m].
std::vector<double> radiiOf(const TriSurface& lumen, const RayGrid& grid) {
  std::vector<double> radii;
  radii.reserve(grid.size());
  for (const Crossings& ray : crossingsOf(lumen, grid)) {
    const std::size_t node = radii.size();
    const auto refuse = [&](std::string_view what) {
      refuseLumen(fmt::format(
          "tissue needs a lumen whose whole side can be seen from its axis (the line from the centre of "
          "the inlet, square to it); at {:.4g} mm along the axis {}",
          1e3 * grid.z(static_cast<int>(node) / grid.around), what));
    };
    if (ray.farthest == 0) refuse("it is not in the lumen");
    if (ray.farthest - ray.nearest > samePlace * grid.zStep) refuse("the lumen's side folds back");
    radii.push_back(ray.farthest);
  }
  return radii;
}

NearestTriangle sideOf(const TriSurface& lumen) {
  std::vector<std::array<std::uint32_t, 3>> side;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (isSide(lumen.region[t])) side.push_back(lumen.triangles[t]);
  return {lumen.vertices, std::move(side)};
}

/// How far from the axis, on each ray, the surface at this distance outside the lumen lies [m].
std::vector<double> outwards(const NearestTriangle& side, const RayGrid& grid,
                             const std::vector<double>& lumen, double distance) {
  constexpr int mostSteps = 200;
  constexpr double accuracy = 1e-4;
  std::vector<double> radii(grid.size(), -1);
  forEachHeavyChunk(grid.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      // The distance grows no faster than the way, so that this comes from within and does not go too far
      double radius = lumen[node] + distance;
      for (int step = 0; step < mostSteps; ++step) {
        const double missing = distance - side.at(grid.place(node, radius)).distance;
        if (missing <= accuracy * distance) {
          radii[node] = radius;
          break;
        }
        radius += missing;
      }
    }
  });
  for (std::size_t node = 0; node < radii.size(); ++node)
    if (radii[node] < 0)
      refuseLumen(
          fmt::format("{:.4g} mm along its axis the lumen is too crooked for a wall to be built {:.4g} "
                      "mm outwards",
                      1e3 * grid.z(static_cast<int>(node) / grid.around), 1e3 * distance));
  return radii;
}

double areaOf(const SurfaceFromAxis& surface, const RayGrid& grid) {
  double area = 0;
  for (std::size_t node = 0; node < grid.size(); ++node)
    area += surface.areaElementAt(grid.place(node, 1)) * grid.share(node);
  return area;
}

}  // namespace

RadiusMap lumenFromAxis(const TriSurface& lumen, double spacing) {
  const RayGrid grid(lumen, spacing);
  return grid.map(radiiOf(lumen, grid));
}

WallShape wallOutwards(const TriSurface& lumen, const VesselParameters& vessel) {
  // As fine as the surfaces that the tissue is held by later are smoothed
  const RayGrid grid(lumen, 2 * vessel.cellRadius);
  const std::vector<double> inside = radiiOf(lumen, grid);
  const NearestTriangle side = sideOf(lumen);
  const double r = vessel.cellRadius, thickness = vessel.wallThickness;
  const auto surfaceAt = [&](double distance) {
    return SurfaceFromAxis(grid.map(outwards(side, grid, inside, distance)));
  };
  WallShape shape{.iel = surfaceAt(r),
                  .inner = surfaceAt(2 * r),
                  .outer = surfaceAt(thickness - 2 * r),
                  .eel = surfaceAt(thickness - r),
                  .ielArea = 0,
                  .eelArea = 0,
                  .volume = 0};
  shape.ielArea = areaOf(shape.iel, grid);
  shape.eelArea = areaOf(shape.eel, grid);
  const std::vector<double> outside = outwards(side, grid, inside, thickness);
  for (std::size_t node = 0; node < grid.size(); ++node)
    shape.volume += 0.5 * (outside[node] * outside[node] - inside[node] * inside[node]) * grid.share(node);
  return shape;
}

}  // namespace restenosis
