#include "bridge/surface/NamedSolids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/SolidNames.h"

namespace restenosis {
namespace {

std::vector<std::uint32_t> trianglesOf(const SurfaceSolids& file, std::uint32_t solid) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < file.solid.size(); ++t)
    if (file.solid[t] == solid) triangles.push_back(t);
  return triangles;
}

/// Parts of an end that no edge joins.
std::vector<LumenCap> piecesOf(const LumenCap& end, const SurfaceEdges& edges) {
  std::set<std::uint32_t> left(end.triangles.begin(), end.triangles.end());
  std::vector<LumenCap> pieces;
  while (!left.empty()) {
    LumenCap piece{{*left.begin()}, end.named, end.solid};
    left.erase(left.begin());
    for (std::size_t n = 0; n < piece.triangles.size(); ++n)
      for (const std::uint32_t other : edges.beyond[piece.triangles[n]])
        if (left.erase(other) > 0) piece.triangles.push_back(other);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

[[noreturn]] void refusePieces(const SurfaceSolids& file, SurfaceRegion which,
                               const std::vector<LumenCap>& pieces) {
  std::string list;
  for (std::size_t n = 0; n < std::min(pieces.size(), placesShown); ++n)
    list += fmt::format("{}{}, {:.4g} mm wide around {}", n == 0 ? "" : ", and ",
                        shownSolids(file, pieces[n].triangles), 1e3 * pieces[n].diameter(file.surface),
                        shownPlace(pieces[n].centre(file.surface)));
  refuseLumen(fmt::format(
      "what is named {} is {} separate pieces: {}{}; it must be one end. Of a "
      "bifurcation take one branch, and close the others; or, without tissue, make each end a solid "
      "of its own, and name the outlets in a table ('outlets' in [flow])",
      regionName(which), pieces.size(), list, pieces.size() > placesShown ? ", and more" : ""));
}

/// A wall of the same name as its end, say.
void requirePlanar(const SurfaceSolids& file, const LumenCap& end) {
  const TriSurface& s = file.surface;
  double area = 0.0;
  for (const auto t : end.triangles) area += s.areaVector(t).norm();
  const double departure = fitPlane(s, end.vertices(s)).departure;
  if (departure <= lumenEndPlanarity * 2.0 * std::sqrt(area / std::numbers::pi)) return;
  refuseLumen(
      fmt::format("{}, named as the {}, which must be planar, has {}, up to {:.3g} mm off a plane. "
                  "Rename it, or give the end a solid of its own",
                  shownSolids(file, end.triangles), regionName(*end.named), shownExtent(s, end.triangles),
                  1e3 * departure));
}

}  // namespace

std::vector<std::optional<SurfaceRegion>> namedRegions(const SurfaceSolids& file) {
  std::vector<std::optional<SurfaceRegion>> regions(file.names.size());
  for (std::uint32_t solid = 0; solid < file.names.size(); ++solid) {
    const auto said = meaningsOf(file.names[solid]);
    if (said.empty()) continue;
    const auto triangles = trianglesOf(file, solid);
    if (triangles.empty()) continue;
    // The name of all there is tells no parts apart: it is the file's title, as "lumen with inlet and outlet"
    const bool title = triangles.size() == file.solid.size() && said != std::vector{SurfaceRegion::strut};
    if (title) continue;
    regions[solid] = said.front();
    if (said.size() < 2) continue;
    refuseLumen(
        fmt::format("the name of {} says that it is {} and {} at once; it has {}. Name it as one of them, "
                    "or as nothing",
                    shownSolids(file.names, {solid}), regionName(said[0]), regionName(said[1]),
                    shownExtent(file.surface, triangles)));
  }
  return regions;
}

std::vector<LumenCap> namedEnds(const SurfaceSolids& file,
                                const std::vector<std::optional<SurfaceRegion>>& regions,
                                const SurfaceEdges& edges, Outlets outlets) {
  std::vector<LumenCap> ends;
  const auto add = [&](LumenCap end) {
    if (end.triangles.empty()) return;
    const auto pieces = piecesOf(end, edges);
    if (pieces.size() > 1) refusePieces(file, *end.named, pieces);
    requirePlanar(file, end);
    ends.push_back(std::move(end));
  };
  const auto named = [&](SurfaceRegion which) {
    LumenCap end{{}, which};
    for (std::uint32_t t = 0; t < file.solid.size(); ++t)
      if (regions[file.solid[t]] == which) end.triangles.push_back(t);
    return end;
  };
  add(named(SurfaceRegion::inlet));
  if (outlets == Outlets::one) {
    add(named(SurfaceRegion::outlet));
    return ends;
  }
  const auto first = static_cast<std::ptrdiff_t>(ends.size());
  for (std::uint32_t solid = 0; solid < file.names.size(); ++solid)
    if (regions[solid] == SurfaceRegion::outlet)
      add({trianglesOf(file, solid), SurfaceRegion::outlet, file.names[solid]});
  std::sort(ends.begin() + first, ends.end(),
            [](const LumenCap& a, const LumenCap& b) { return a.solid < b.solid; });
  return ends;
}

std::string shownExtent(const TriSurface& surface, const std::vector<std::uint32_t>& triangles) {
  Eigen::AlignedBox3d box;
  double area = 0.0;
  for (const auto t : triangles) {
    area += surface.areaVector(t).norm();
    for (const auto v : surface.triangles[t]) box.extend(surface.vertices[v]);
  }
  const std::string low = shownPlace(box.min());
  return fmt::format("{} {} of {:.4g} mm2 from {} to {}", triangles.size(),
                     triangles.size() == 1 ? "triangle" : "triangles", 1e6 * area,
                     low.substr(0, low.rfind(" mm")), shownPlace(box.max()));
}

}  // namespace restenosis
