#include "LoadedLumen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "LengthUnit.h"
#include "LumenCap.h"
#include "LumenRefusal.h"
#include "LumenRims.h"
#include "StlFile.h"
#include "SurfaceCrossings.h"
#include "SurfaceEnds.h"
#include "SurfacePieces.h"

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

/// What a solid's name says.
std::optional<SurfaceRegion> meaning(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [word, region] : {std::pair{"inlet", SurfaceRegion::inlet},
                                     {"outlet", SurfaceRegion::outlet},
                                     {"strut", SurfaceRegion::strut},
                                     {"stent", SurfaceRegion::strut}})
    if (name.find(word) != std::string::npos) return region;
  return std::nullopt;
}

/// Parts of an end that no edge joins.
std::vector<LumenCap> piecesOf(const LumenCap& end, const SurfaceEdges& edges) {
  std::set<std::uint32_t> left(end.triangles.begin(), end.triangles.end());
  std::vector<LumenCap> pieces;
  while (!left.empty()) {
    LumenCap piece{{*left.begin()}, end.named};
    left.erase(left.begin());
    for (std::size_t n = 0; n < piece.triangles.size(); ++n)
      for (const std::uint32_t other : edges.beyond[piece.triangles[n]])
        if (left.erase(other) > 0) piece.triangles.push_back(other);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<LumenCap> namedEnds(const StlSolids& file, const SurfaceEdges& edges) {
  std::vector<LumenCap> ends;
  for (const SurfaceRegion which : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
    LumenCap end{{}, which};
    for (std::uint32_t t = 0; t < file.solid.size(); ++t)
      if (meaning(file.names[file.solid[t]]) == which) end.triangles.push_back(t);
    if (end.triangles.empty()) continue;
    const auto pieces = piecesOf(end, edges);
    if (pieces.size() > 1)
      refuseLumen(
          fmt::format("what is named {} is {} separate pieces, {:.4g} mm wide around {} and {:.4g} mm "
                      "around {}; it must be one end",
                      regionName(which), pieces.size(), 1e3 * pieces[0].diameter(file.surface),
                      shownPlace(pieces[0].centre(file.surface)), 1e3 * pieces[1].diameter(file.surface),
                      shownPlace(pieces[1].centre(file.surface))));
    ends.push_back(std::move(end));
  }
  return ends;
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
  if (ends.size() != 2) {
    std::string where;
    for (std::size_t n = 0; n < std::min(ends.size(), placesShown); ++n)
      where += fmt::format("{} {:.4g} mm wide around {}", n == 0 ? ":" : ",", 1e3 * ends[n].diameter(s),
                           shownPlace(ends[n].centre(s)));
    refuseLumen(
        fmt::format("it needs two planar ends, open or closed by a flat cap with a sharp rim, but {} {} "
                    "found ({} of them open){}. Cut the ends straight, close holes, or name the solids of "
                    "the ends inlet and outlet",
                    ends.size(), ends.size() == 1 ? "was" : "were", rims, where));
  }
  return ends;
}

/// Puts the inlet first.
void sortEnds(const TriSurface& s, std::vector<LumenCap>& ends) {
  bool swap = false;
  if (ends[0].named || ends[1].named) {
    swap = ends[0].named == SurfaceRegion::outlet || ends[1].named == SurfaceRegion::inlet;
  } else {
    Eigen::Index axis = 0;
    const Vec3 between = ends[1].centre(s) - ends[0].centre(s);
    between.cwiseAbs().maxCoeff(&axis);
    swap = between[axis] < 0.0;
  }
  if (swap) std::swap(ends[0], ends[1]);
}

void requireSize(const TriSurface& s, const std::vector<LumenCap>& ends) {
  const double a = ends[0].diameter(s), b = ends[1].diameter(s);
  const double ratio = std::min(a, b) / std::max(a, b);
  if (ratio * ratio < leastAreaRatio)
    refuseLumen(
        fmt::format("its two planar ends are {:.3g} and {:.3g} mm wide: the smaller looks like a hole, and "
                    "an end is missing",
                    1e3 * a, 1e3 * b));
  for (const double d : {a, b})
    if (!(d >= leastDiameter && d <= largestDiameter))
      refuseLumen(
          fmt::format("an end is {:.4g} mm wide, not between {:g} and {:g} mm: is the length unit right?",
                      1e3 * d, 1e3 * leastDiameter, 1e3 * largestDiameter));
}

}  // namespace

TriSurface loadLumen(const std::filesystem::path& file, double metresPerUnit) {
  StlSolids read = readStlSolids(file, metresPerUnit);
  TriSurface& s = read.surface;
  requireDepth(s);
  if (const std::size_t crowded = surfaceEdges(s).crowded; crowded > 0)
    refuseLumen(fmt::format("{} edges have more than two triangles: parts of it overlap or meet in one edge",
                            crowded));
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (meaning(read.names[read.solid[t]]) == SurfaceRegion::strut) s.region[t] = SurfaceRegion::strut;

  const std::vector<std::uint32_t> pieceOf = orientPieces(s);
  if (const std::size_t pieces = 1 + std::ranges::max(pieceOf); pieces != 1)
    refuseLumen(fmt::format("it consists of {} separate pieces; a lumen is one", pieces));
  const SurfaceEdges edges = surfaceEdges(s);
  if (edges.opposed > 0) refuseLumen("it has only one side, like a Moebius strip");
  std::vector<LumenCap> ends = namedEnds(read, edges);
  const std::vector<Rim> rims = endRims(s, edges);
  // Before ends are closed and made planar: in the file's own shape, and not where that moves vertices
  if (const SurfaceCrossings crossings = surfaceCrossings(s, pieceOf); crossings.edges > 0)
    refuseLumen(fmt::format("it passes through itself: {} {} through other triangles of it, {} at {}",
                            crossings.edges, crossings.edges == 1 ? "edge goes" : "edges go",
                            crossings.edges == 1 ? "that" : "one", shownPlace(crossings.place)));
  for (const Rim& rim : rims) ends.push_back(closeRim(s, rim));
  turnOutwards(s);

  ends = findEnds(s, std::move(ends), rims.size());
  requireSize(s, ends);
  for (const LumenCap& end : ends) flatten(s, end);
  sortEnds(s, ends);
  for (const auto t : ends[0].triangles) s.region[t] = SurfaceRegion::inlet;
  for (const auto t : ends[1].triangles) s.region[t] = SurfaceRegion::outlet;
  if (std::ranges::find(s.region, SurfaceRegion::wall) == s.region.end())
    refuseLumen(
        "there is no wall in it: every solid beside the ends has 'strut' or 'stent' in its name; rename that "
        "of the wall");
  return s;
}

TriSurface loadLumen(const VesselParameters& vessel) {
  return loadLumen(vessel.lumenSurface, metresPer(vessel.lumenSurfaceUnit));
}

double endDiameter(const TriSurface& lumen, SurfaceRegion end) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end) sum += lumen.areaVector(t);
  return 2.0 * std::sqrt(sum.norm() / std::numbers::pi);
}

}  // namespace restenosis
