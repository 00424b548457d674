#include "bridge/surface/LoadedLumen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>

#include "bridge/surface/LengthUnit.h"
#include "bridge/surface/LumenCap.h"
#include "bridge/surface/LumenParts.h"
#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/LumenRims.h"
#include "bridge/surface/NamedSolids.h"
#include "bridge/surface/SolidNames.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceCrossings.h"
#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/SurfacePieces.h"

namespace restenosis {
namespace {

/// Area over the other end's below which an end is taken for a hole (assumed).
constexpr double leastAreaRatio = 0.01;
/// Diameters that a lumen may have [m] (assumed; the largest is that of `vessel.lumenDiameter`).
constexpr double leastDiameter = 0.02e-3, largestDiameter = 50e-3;
/// How far the vertices of a flat surface are from its plane, over its length (assumed).
constexpr double flatDepth = 1e-6;

/// Refuses what lies in a plane, such as a single triangle.
void requireDepth(const TriSurface& s) {
  std::vector<std::uint32_t> all(s.vertices.size());
  std::iota(all.begin(), all.end(), 0U);
  const FittedPlane plane = fitPlane(s, all);
  double reach = 0.0;
  for (const Vec3& v : s.vertices) reach = std::max(reach, (v - plane.centre).norm());
  if (plane.departure <= flatDepth * reach)
    refuseLumen(fmt::format("it encloses no lumen: it is flat, {} {}", s.triangles.size(),
                            s.triangles.size() == 1 ? "triangle" : "triangles in one plane"));
}

/// Says which pieces there are, the largest first.
[[noreturn]] void refusePieces(const SurfaceSolids& file, const std::vector<std::uint32_t>& pieceOf) {
  std::vector<std::vector<std::uint32_t>> pieces(1 + std::ranges::max(pieceOf));
  for (std::uint32_t t = 0; t < pieceOf.size(); ++t) pieces[pieceOf[t]].push_back(t);
  std::ranges::stable_sort(pieces, std::greater(), [](const auto& piece) { return piece.size(); });
  std::string list;
  for (std::size_t n = 0; n < std::min(pieces.size(), placesShown); ++n) {
    const std::string solids = shownSolids(file, pieces[n]);
    list += fmt::format("{} {}{}{}", n == 0 ? "" : ";", shownExtent(file.surface, pieces[n]),
                        solids.empty() ? "" : ", of ", solids);
  }
  refuseLumen(fmt::format(
      "it consists of {} separate pieces; a lumen is one. They are{}{}. Remove those that are not the "
      "lumen's "
      "wall; join those that touch, so that their triangles have the vertices of their common edge in common",
      pieces.size(), list, pieces.size() > placesShown ? "; and more" : ""));
}

/// Puts the vertices of an end exactly into its plane.
void flatten(TriSurface& s, const LumenCap& end) {
  const auto vertices = end.vertices(s);
  const FittedPlane plane = fitPlane(s, vertices);
  if (plane.departure > lumenEndPlanarity * end.diameter(s))
    refuseLumen(fmt::format("the end at {} is not planar: off by {:.3g} mm", shownPlace(plane.centre),
                            1e3 * plane.departure));
  for (const auto v : vertices)
    s.vertices[v] -= plane.normal.dot(s.vertices[v] - plane.centre) * plane.normal;
}

/// What is said of other ends than two.
[[noreturn]] void refuseEnds(const TriSurface& s, const std::vector<LumenCap>& ends, std::size_t open) {
  std::string where;
  for (std::size_t n = 0; n < std::min(ends.size(), placesShown); ++n)
    where += fmt::format("{} {:.4g} mm wide around {}", n == 0 ? ":" : ",", 1e3 * ends[n].diameter(s),
                         shownPlace(ends[n].centre(s)));
  if (ends.size() > placesShown) where += ", and more";
  if (ends.size() > 2)
    refuseLumen(fmt::format(
        "it needs two planar ends, one inlet and one outlet, but {} were found ({} of them open){}. "
        "Of a bifurcation take one branch; or close the others and name the solids of the ends inlet and "
        "outlet, which also tells ends from other flat faces; or, without tissue, make each end a solid of "
        "its "
        "own, and name the outlets in a table ('outlets' in [flow])",
        ends.size(), open, where));
  refuseLumen(fmt::format(
      "it needs two planar ends, open or closed by a flat cap with a sharp rim, but {} {} found ({} "
      "of them open){}. Cut the ends straight, close holes, or name the solids of the ends inlet "
      "and outlet",
      ends.size(), ends.size() == 1 ? "was" : "were", open, where));
}

/// The two ends, or a refusal that says what was found. Where just two rims are open, these are the ends: the
/// flat sides of a duct look like caps.
std::vector<LumenCap> findEnds(TriSurface& s, std::vector<LumenCap> ends, std::size_t rims) {
  const bool bothOpen = rims == 2 && ends.size() == 2;
  if (!bothOpen && (ends.size() < 2 || rims > 0)) {
    std::vector<bool> taken(s.triangles.size(), false);
    for (const LumenCap& end : ends)
      for (const auto t : end.triangles) taken[t] = true;
    for (auto& cap : planarCaps(s, surfaceEdges(s)))
      if (std::none_of(cap.begin(), cap.end(), [&](auto t) { return taken[t]; }))
        ends.push_back({std::move(cap), std::nullopt});
  }
  if (ends.size() != 2) refuseEnds(s, ends, rims);
  return ends;
}

/// More open rims than two are those of a bifurcation, whether they are planar or not.
void refuseManyRims(const TriSurface& s, const std::vector<Rim>& rims) {
  if (rims.size() < 3) return;
  TriSurface closed = s;
  std::vector<LumenCap> ends;
  for (const Rim& rim : rims) ends.push_back(closeByFan(closed, rim, fitPlane(closed, rim).centre));
  refuseEnds(closed, ends, rims.size());
}

/// Puts the inlet first.
void sortEnds(const TriSurface& s, std::vector<LumenCap>& ends) {
  bool swap = false;
  if (ends[0].named || ends[1].named) {
    swap = ends[0].named == SurfaceRegion::outlet || ends[1].named == SurfaceRegion::inlet;
  } else {
    swap = (ends[1].centre(s) - ends[0].centre(s))[axisBetween(s, ends)] < 0.0;
  }
  if (swap) std::swap(ends[0], ends[1]);
}

/// Of several outlets all must be told by name; whatever else there is would leak.
void requireNamedTree(const TriSurface& s, const std::vector<LumenCap>& ends, std::size_t rims) {
  if (ends.size() > mostOutlets + 1)
    refuseLumen(fmt::format("it has {} outlets; at most {} are supported", ends.size() - 1, mostOutlets));
  if (ends.front().named != SurfaceRegion::inlet)
    refuseLumen(fmt::format("{} solids are named as outlets, but none as the inlet", ends.size()));
  if (rims > 0)
    refuseLumen(fmt::format(
        "it has {} outlets that are named, and {} open: close it, and name what closes it as an outlet",
        ends.size() - 1, rims == 1 ? "one end that is" : fmt::format("{} ends that are", rims)));
  for (std::size_t n = 2; n < ends.size(); ++n)
    if (ends[n].solid == ends[n - 1].solid)
      refuseLumen(fmt::format("two outlets are named '{}', around {} and {}: give them names of their own",
                              ends[n].solid, shownPlace(ends[n - 1].centre(s)),
                              shownPlace(ends[n].centre(s))));
}

void requireSize(const TriSurface& s, const std::vector<LumenCap>& ends) {
  const double a = ends[0].diameter(s), b = ends[1].diameter(s);
  const double ratio = std::min(a, b) / std::max(a, b);
  // A branch may be as narrow as that
  if (ends.size() == 2 && ratio * ratio < leastAreaRatio)
    refuseLumen(
        fmt::format("its two planar ends are {:.3g} and {:.3g} mm wide: the smaller looks like a hole, and "
                    "an end is missing",
                    1e3 * a, 1e3 * b));
  for (const LumenCap& end : ends)
    if (const double d = end.diameter(s); !(d >= leastDiameter && d <= largestDiameter))
      refuseLumen(
          fmt::format("an end is {:.4g} mm wide, not between {:g} and {:g} mm: is the length unit right?",
                      1e3 * d, 1e3 * leastDiameter, 1e3 * largestDiameter));
}

/// A cap of a strut is no end.
void requireEndsOfWall(const SurfaceSolids& file, const std::vector<LumenCap>& ends) {
  for (const LumenCap& end : ends) {
    if (end.named) continue;
    const auto strut = std::ranges::find_if(end.triangles, [&](auto t) {
      return t < file.solid.size() && file.surface.region[t] == SurfaceRegion::strut;
    });
    if (strut == end.triangles.end()) continue;
    refuseLumen(
        fmt::format("in {}, named as struts, there is the end of the lumen {:.4g} mm wide around {}. "
                    "Rename it, or give the end a solid of its own",
                    shownSolids(file.names, {file.solid[*strut]}), 1e3 * end.diameter(file.surface),
                    shownPlace(end.centre(file.surface))));
  }
}

void requireWall(const SurfaceSolids& file) {
  const auto& regions = file.surface.region;
  if (std::ranges::find(regions, SurfaceRegion::wall) != regions.end()) return;
  std::vector<std::uint32_t> struts;
  for (std::uint32_t t = 0; t < regions.size(); ++t)
    if (regions[t] == SurfaceRegion::strut) struts.push_back(t);
  if (struts.empty()) refuseLumen("there is no wall in it: all of it is inlet and outlet");
  refuseLumen(fmt::format(
      "there is no wall in it: beside the ends there is only {}, named as struts; rename that of the wall",
      shownSolids(file, struts)));
}

}  // namespace

DescribedLumen loadDescribedLumen(const std::filesystem::path& path, double metresPerUnit, Outlets outlets) {
  SurfaceSolids file = readSurfaceSolids(path, metresPerUnit);
  TriSurface& s = file.surface;
  requireDepth(s);
  const auto named = namedRegions(file);
  if (const auto& crowded = surfaceEdges(s).crowdedEdges; !crowded.empty())
    refuseLumen(
        fmt::format("{} more than two triangles: {}. Parts of it overlap or meet in one edge "
                    "there; remove what is there twice or lies within the lumen, or move the parts apart",
                    crowded.size() == 1 ? "an edge has" : fmt::format("{} edges have", crowded.size()),
                    shownEdges(s, crowded)));
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (named[file.solid[t]] == SurfaceRegion::strut) s.region[t] = SurfaceRegion::strut;

  const std::vector<std::uint32_t> pieceOf = orientPieces(s);
  if (std::ranges::max(pieceOf) > 0) refusePieces(file, pieceOf);
  const SurfaceEdges edges = surfaceEdges(s);
  if (edges.opposed > 0) refuseLumen("it has only one side, like a Moebius strip");
  std::vector<LumenCap> ends = namedEnds(file, named, edges, outlets);
  const std::vector<Rim> rims = endRims(s, edges);
  // Before ends are closed and made planar: in the file's own shape, and not where that moves vertices
  if (const SurfaceCrossings crossings = surfaceCrossings(s, pieceOf); crossings.edges > 0)
    refuseLumen(fmt::format("it passes through itself: {} {} through other triangles of it, {} at {}",
                            crossings.edges, crossings.edges == 1 ? "edge goes" : "edges go",
                            crossings.edges == 1 ? "that" : "one", shownPlace(crossings.place)));
  const bool isTree = std::ranges::count(ends, SurfaceRegion::outlet, &LumenCap::named) > 1;
  if (isTree) {
    requireNamedTree(s, ends, rims.size());
    turnOutwards(s);
  } else {
    refuseManyRims(s, rims);
    for (const Rim& rim : rims) ends.push_back(closeRim(s, rim));
    turnOutwards(s);
    ends = findEnds(s, std::move(ends), rims.size());
  }
  requireSize(s, ends);
  requireEndsOfWall(file, ends);
  for (const LumenCap& end : ends) flatten(s, end);
  if (!isTree) sortEnds(s, ends);
  for (const auto t : ends[0].triangles) s.region[t] = SurfaceRegion::inlet;
  for (std::size_t n = 1; n < ends.size(); ++n)
    for (const auto t : ends[n].triangles) s.region[t] = outletRegion(n - 1);
  requireWall(file);
  DescribedLumen result;
  for (const LumenCap& end : ends)
    if (isTree && end.named == SurfaceRegion::outlet) result.outlets.push_back(end.solid);
  result.parts = lumenParts(file, ends);
  if (std::string faces = remarkOnOtherFaces(file, ends); !faces.empty())
    result.remarks.push_back(std::move(faces));
  if (std::string struts = remarkOnStruts(file); !struts.empty()) result.remarks.push_back(std::move(struts));
  result.surface = std::move(s);
  return result;
}

DescribedLumen loadDescribedLumen(const VesselParameters& vessel, Outlets outlets) {
  return loadDescribedLumen(vessel.lumenSurface, metresPer(vessel.lumenSurfaceUnit), outlets);
}

TriSurface loadLumen(const std::filesystem::path& file, double metresPerUnit, Outlets outlets) {
  return loadDescribedLumen(file, metresPerUnit, outlets).surface;
}

TriSurface loadLumen(const VesselParameters& vessel, Outlets outlets) {
  return loadDescribedLumen(vessel, outlets).surface;
}

double endDiameter(const TriSurface& lumen, SurfaceRegion end) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end) sum += lumen.areaVector(t);
  return 2.0 * std::sqrt(sum.norm() / std::numbers::pi);
}

}  // namespace restenosis
