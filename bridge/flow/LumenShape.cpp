#include "bridge/flow/LumenShape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bridge/surface/StlFile.h"

namespace restenosis {
namespace {

/// Largest departure of an end from its plane, over its distance from the axis origin or its size.
constexpr double planarity = 1e-6;

void requireFinite(const TriSurface& lumen) {
  if (lumen.triangles.empty()) throw std::invalid_argument("the lumen surface has no triangles");
  if (lumen.region.size() != lumen.triangles.size())
    throw std::invalid_argument(fmt::format("the lumen surface has {} triangles but {} regions",
                                            lumen.triangles.size(), lumen.region.size()));
  for (const Vec3& v : lumen.vertices)
    if (!v.allFinite()) throw std::invalid_argument("the lumen surface has a vertex that is not a number");
  for (const auto& t : lumen.triangles)
    if (*std::max_element(t.begin(), t.end()) >= lumen.vertices.size())
      throw std::invalid_argument("a triangle of the lumen surface names a vertex that does not exist");
}

void requireClosed(const TriSurface& lumen) {
  struct Edge {
    std::uint32_t low, high;
    int direction;
    bool operator<(const Edge& o) const { return low != o.low ? low < o.low : high < o.high; }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * lumen.triangles.size());
  for (const auto& t : lumen.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    std::size_t j = i;
    for (; j < edges.size() && !(edges[i] < edges[j]); ++j) balance += edges[j].direction;
    if (balance != 0 || (j - i) % 2 != 0) ++open;
    i = j;
  }
  if (open > 0)
    throw std::invalid_argument(fmt::format(
        "the lumen surface is not closed: {} edges belong to one triangle only or to two of opposite "
        "orientation",
        open));
}

void requireSound(const TriSurface& lumen) {
  requireFinite(lumen);
  requireClosed(lumen);
  if (!(enclosedVolume(lumen) > 0.0))
    throw std::invalid_argument("the normals of the lumen surface point into the lumen");
}

}  // namespace

void requireLumen(const TriSurface& lumen) {
  requireSound(lumen);
  if (!(lumenEnd(lumen, SurfaceRegion::inlet).z < lumenEnd(lumen, SurfaceRegion::outlet).z))
    throw std::invalid_argument("the inlet of the lumen surface must lie below its outlet on the z axis");
}

LumenEnd lumenEnd(const TriSurface& lumen, SurfaceRegion end) {
  const std::string_view name = regionName(end);
  LumenEnd result{0.0, 0.0, Vec3::Zero()};
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != end) continue;
    const double area = lumen.areaVector(i).norm();
    result.area += area;
    result.centre += area * lumen.centre(i);
    for (const auto v : lumen.triangles[i]) {
      lowest = std::min(lowest, lumen.vertices[v].z());
      highest = std::max(highest, lumen.vertices[v].z());
    }
  }
  if (!(result.area > 0.0)) throw std::invalid_argument(fmt::format("the lumen surface has no {}", name));
  if (highest - lowest > planarity * std::sqrt(result.area))
    throw std::invalid_argument(
        fmt::format("the {} of the lumen surface is not a plane of constant z: it spans {} "
                    "to {} m",
                    name, lowest, highest));
  result.centre /= result.area;
  result.z = 0.5 * (lowest + highest);
  return result;
}

EndPlane endPlane(const TriSurface& lumen, SurfaceRegion end) {
  EndPlane result{Vec3::Zero(), Vec3::Zero(), 0.0};
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != end) continue;
    const Vec3 areaVector = lumen.areaVector(i);
    result.normal += areaVector;
    result.area += areaVector.norm();
    result.centre += areaVector.norm() * lumen.centre(i);
  }
  if (!(result.area > 0.0))
    throw std::invalid_argument(fmt::format("the lumen surface has no {}", regionName(end)));
  result.centre /= result.area;
  result.normal.normalize();
  double farthest = 0.0;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != end) continue;
    for (const auto v : lumen.triangles[i])
      farthest = std::max(farthest, std::abs(result.normal.dot(lumen.vertices[v] - result.centre)));
  }
  if (farthest > planarity * std::sqrt(result.area))
    throw std::invalid_argument(fmt::format(
        "the {} of the lumen surface is not planar: a vertex is {:.3g} m off", regionName(end), farthest));
  for (const auto& [from, to] : endRim(lumen, end))
    result.perimeter += (lumen.vertices[to] - lumen.vertices[from]).norm();
  return result;
}

std::vector<std::array<std::uint32_t, 2>> endRim(const TriSurface& lumen, SurfaceRegion end) {
  std::vector<std::array<std::uint32_t, 2>> edges, rim;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != end) continue;
    const auto& t = lumen.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  }
  std::ranges::sort(edges);
  for (const auto& [from, to] : edges)
    if (!std::ranges::binary_search(edges, std::array{to, from})) rim.push_back({from, to});
  return rim;
}

void requireLumenWithPlanarEnds(const TriSurface& lumen) {
  requireSound(lumen);
  endPlane(lumen, SurfaceRegion::inlet);
  for (std::size_t n = 0; n < std::max<std::size_t>(1, lumen.outletCount()); ++n)
    endPlane(lumen, outletRegion(n));
}

bool liesAlongZ(const TriSurface& lumen) {
  if (lumen.outletCount() > 1) return false;
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  const EndPlane outlet = endPlane(lumen, SurfaceRegion::outlet);
  const double low = inlet.centre.z(), high = outlet.centre.z();
  const double slack = planarity * std::max(std::sqrt(inlet.area), high - low);
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i)
    for (const auto v : lumen.triangles[i]) {
      const double z = lumen.vertices[v].z();
      const double lowest = lumen.region[i] == SurfaceRegion::outlet ? high : low;
      const double highest = lumen.region[i] == SurfaceRegion::inlet ? low : high;
      if (z < lowest - slack || z > highest + slack) return false;
    }
  return low < high;
}

std::vector<CrossSection> crossSections(const TriSurface& lumen, std::span<const double> stations) {
  std::vector<CrossSection> sections(stations.size(), {0.0, 0.0, Vec3::Zero()});
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    const auto& t = lumen.triangles[i];
    const Vec3 outward = lumen.areaVector(i);
    const double low =
        std::min({lumen.vertices[t[0]].z(), lumen.vertices[t[1]].z(), lumen.vertices[t[2]].z()});
    const double high =
        std::max({lumen.vertices[t[0]].z(), lumen.vertices[t[1]].z(), lumen.vertices[t[2]].z()});
    const auto first = std::ranges::lower_bound(stations, low);
    for (auto s = static_cast<std::size_t>(first - stations.begin()); s < stations.size(); ++s) {
      const double z = stations[s];
      if (z > high) break;
      Vec3 cut[2];
      int count = 0;
      for (int k = 0; k < 3 && count < 2; ++k) {
        const Vec3 &a = lumen.vertices[t[k]], &b = lumen.vertices[t[(k + 1) % 3]];
        // A vertex in the plane counts as above it, so that the contour closes
        if ((a.z() >= z) == (b.z() >= z)) continue;
        cut[count++] = a + (z - a.z()) / (b.z() - a.z()) * (b - a);
      }
      if (count < 2) continue;
      const double turn = cut[0].x() * cut[1].y() - cut[1].x() * cut[0].y();
      const bool counterclockwise = (cut[1] - cut[0]).dot(Vec3::UnitZ().cross(outward)) >= 0.0;
      const double area = counterclockwise ? 0.5 * turn : -0.5 * turn;
      sections[s].area += area;
      sections[s].perimeter += (cut[1] - cut[0]).norm();
      sections[s].centre += area / 3.0 * (cut[0] + cut[1]);
    }
  }
  for (std::size_t s = 0; s < stations.size(); ++s) {
    sections[s].centre /= sections[s].area;
    sections[s].centre.z() = stations[s];
  }
  return sections;
}

std::vector<double> crossSectionAreas(const TriSurface& lumen, std::span<const double> stations) {
  std::vector<double> areas;
  for (const CrossSection& section : crossSections(lumen, stations)) areas.push_back(section.area);
  return areas;
}

}  // namespace restenosis
