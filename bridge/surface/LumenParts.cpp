#include "bridge/surface/LumenParts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/NamedSolids.h"
#include "bridge/surface/SolidNames.h"
#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

/// Share of the side beyond which solids named strut are hardly struts: stents cover a tenth to a quarter of
/// a wall, and their edges stand in the lumen (assumed).
constexpr double mostStrut = 0.5;
/// Angle between wall and strut, as at a rim of a cap, and the part of their common edges that should have it
/// (assumed).
constexpr double reliefAngle = 30 * std::numbers::pi / 180, leastRelief = 0.1;

std::vector<std::uint32_t> trianglesOf(const TriSurface& s, SurfaceRegion region) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
    if (s.region[t] == region) triangles.push_back(t);
  return triangles;
}

double areaOf(const TriSurface& s, const std::vector<std::uint32_t>& triangles) {
  return std::accumulate(triangles.begin(), triangles.end(), 0.0,
                         [&](double sum, std::uint32_t t) { return sum + s.areaVector(t).norm(); });
}

std::string endLine(const SurfaceSolids& file, const LumenCap& end, SurfaceRegion which) {
  const TriSurface& s = file.surface;
  const std::string solids = shownSolids(file, end.triangles);
  const std::string from = end.named ? fmt::format("{}, by its name", solids)
                           : solids.empty() && end.triangles.front() >= file.solid.size()
                               ? "an open rim, closed"
                           : solids.empty() ? "a flat cap"
                                            : fmt::format("a flat cap in {}", solids);
  return fmt::format("{:<7} {:.4g} mm2, {:.4g} mm wide around {}: {}", regionName(which),
                     1e6 * areaOf(s, end.triangles), 1e3 * end.diameter(s), shownPlace(end.centre(s)), from);
}

/// Length of the edges between wall and strut, and of those where the surface turns [m].
struct Border {
  double length = 0, turning = 0;
};

Border borderOfStruts(const TriSurface& s) {
  const SurfaceEdges edges = surfaceEdges(s);
  Border border;
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
    if (s.region[t] != SurfaceRegion::strut) continue;
    for (int k = 0; k < 3; ++k) {
      const auto other = edges.beyond[t][k];
      if (other == SurfaceEdges::none || s.region[other] != SurfaceRegion::wall) continue;
      const double length = (s.vertices[s.triangles[t][k]] - s.vertices[s.triangles[t][(k + 1) % 3]]).norm();
      const Vec3 a = s.areaVector(t), b = s.areaVector(other);
      border.length += length;
      if (a.dot(b) <= std::cos(reliefAngle) * a.norm() * b.norm()) border.turning += length;
    }
  }
  return border;
}

}  // namespace

Eigen::Index axisBetween(const TriSurface& surface, const std::vector<LumenCap>& ends) {
  Eigen::Index axis = 0;
  (ends[1].centre(surface) - ends[0].centre(surface)).cwiseAbs().maxCoeff(&axis);
  return axis;
}

std::vector<std::string> lumenParts(const SurfaceSolids& file, const std::vector<LumenCap>& ends) {
  const TriSurface& s = file.surface;
  std::vector<std::string> lines{endLine(file, ends[0], SurfaceRegion::inlet)};
  for (std::size_t n = 1; n < ends.size(); ++n) lines.push_back(endLine(file, ends[n], outletRegion(n - 1)));
  for (const SurfaceRegion region : {SurfaceRegion::wall, SurfaceRegion::strut}) {
    const auto triangles = trianglesOf(s, region);
    if (triangles.empty()) {
      lines.push_back(fmt::format("{:<7} none: no solid is named so", regionName(region)));
      continue;
    }
    const std::string solids = shownSolids(file, triangles);
    lines.push_back(fmt::format("{:<7} {}: {}", regionName(region), shownExtent(s, triangles),
                                solids.empty() ? "what is no end" : solids));
  }
  if (!ends[0].named && !ends[1].named)
    lines.push_back(fmt::format("no solid is named inlet or outlet: the inlet is the end with the lower {}",
                                "xyz"[axisBetween(s, ends)]));
  return lines;
}

std::string remarkOnOtherFaces(const SurfaceSolids& file, const std::vector<LumenCap>& ends) {
  const TriSurface& s = file.surface;
  if (!ends[0].named || !ends[1].named) return {};
  std::string list;
  std::size_t faces = 0;
  for (auto& triangles : planarCaps(s, surfaceEdges(s))) {
    const SurfaceRegion region = s.region[triangles.front()];
    if (isEnd(region)) continue;
    const LumenCap face{std::move(triangles), std::nullopt};
    if (++faces > placesShown) continue;
    list += fmt::format("{} {:.4g} mm wide around {}, in {}", faces == 1 ? "" : ";", 1e3 * face.diameter(s),
                        shownPlace(face.centre(s)), shownSolids(file, face.triangles));
  }
  if (faces == 0) return {};
  return fmt::format(
      "beside the ends that are named, {} flat {} with a sharp rim {} taken as wall, through which "
      "nothing flows:{}{}",
      faces, faces == 1 ? "face" : "faces", faces == 1 ? "is" : "are", list,
      faces > placesShown ? "; and more" : "");
}

std::string remarkOnStruts(const SurfaceSolids& file) {
  const TriSurface& s = file.surface;
  const auto struts = trianglesOf(s, SurfaceRegion::strut);
  if (struts.empty()) return {};
  const double strut = areaOf(s, struts), wall = areaOf(s, trianglesOf(s, SurfaceRegion::wall));
  const double share = strut / (strut + wall);
  const Border border = borderOfStruts(s);
  std::string why;
  if (share > mostStrut)
    why = fmt::format(" makes {:.3g} % of the lumen's side struts", 100 * share);
  else if (border.turning < leastRelief * border.length)
    why = ", named as struts, lies in the wall without an edge";
  else
    return {};
  return fmt::format("{}{}, {}: the stress on struts does not count as the wall's. Are they struts?",
                     shownSolids(file, struts), why, shownExtent(s, struts));
}

}  // namespace restenosis
