#include "LoadedLumen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "StlFile.h"
#include "SurfaceEnds.h"

namespace restenosis {
namespace {

/// How far an end may be from a plane, over its diameter (assumed); it is made planar.
constexpr double planarity = 0.02;
/// Area over the other end's below which an end is taken for a hole (assumed).
constexpr double leastAreaRatio = 0.01;
/// Diameters that a lumen may have [m] (assumed; the largest is that of `vessel.lumenDiameter`).
constexpr double leastDiameter = 0.02e-3, largestDiameter = 50e-3;

[[noreturn]] void refuse(const std::string& reason) {
  throw std::runtime_error("the lumen surface cannot be used: " + reason);
}

/// A place for people, without the round-off of zeros.
std::string shown(const Vec3& p) {
  const Vec3 rounded = (1e6 * p).array().round() * 1e-3 + 0.0;  // [mm], of whole micrometres; -0 is 0
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", rounded.x(), rounded.y(), rounded.z());
}

/// Makes triangles that meet run along their edge in opposite directions, starting from the first.
/// Returns the number of pieces that the surface consists of.
std::size_t orient(TriSurface& s) {
  const SurfaceEdges edges = surfaceEdges(s);
  std::vector<bool> done(s.triangles.size(), false);
  std::size_t pieces = 0;
  const auto runsAlong = [&](std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    for (int k = 0; k < 3; ++k)
      if (s.triangles[t][k] == from && s.triangles[t][(k + 1) % 3] == to) return true;
    return false;
  };
  for (std::uint32_t seed = 0; seed < s.triangles.size(); ++seed) {
    if (done[seed]) continue;
    ++pieces;
    std::vector<std::uint32_t> front{seed};
    done[seed] = true;
    while (!front.empty()) {
      const std::uint32_t t = front.back();
      front.pop_back();
      const auto corners = s.triangles[t];
      for (const std::uint32_t other : edges.beyond[t]) {
        if (other == SurfaceEdges::none || done[other]) continue;
        for (int k = 0; k < 3; ++k)
          if (runsAlong(other, corners[k], corners[(k + 1) % 3])) {
            std::swap(s.triangles[other][1], s.triangles[other][2]);
            break;
          }
        done[other] = true;
        front.push_back(other);
      }
    }
  }
  return pieces;
}

/// One end: its triangles, and which it is where a solid's name says so.
struct End {
  std::vector<std::uint32_t> triangles;
  std::optional<SurfaceRegion> named;

  Vec3 areaVector(const TriSurface& s) const {
    return std::accumulate(triangles.begin(), triangles.end(), Vec3(Vec3::Zero()),
                           [&](const Vec3& sum, std::uint32_t t) { return Vec3(sum + s.areaVector(t)); });
  }
  double diameter(const TriSurface& s) const {
    return 2.0 * std::sqrt(areaVector(s).norm() / std::numbers::pi);
  }
  std::vector<std::uint32_t> vertices(const TriSurface& s) const {
    std::vector<std::uint32_t> all;
    for (const auto t : triangles) all.insert(all.end(), s.triangles[t].begin(), s.triangles[t].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }
};

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

/// Closes an open rim by a fan about its centre, all in the rim's plane.
End closeRim(TriSurface& s, const std::vector<std::uint32_t>& rim) {
  const FittedPlane plane = fitPlane(s, rim);
  double length = 0.0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    length += (s.vertices[rim[k]] - s.vertices[rim[(k + 1) % rim.size()]]).norm();
  if (plane.departure > planarity * length / std::numbers::pi)
    refuse(
        fmt::format("an open rim of {} edges around {} is not planar (off by {:.3g} mm): it is a hole, or "
                    "an end that must be cut straight",
                    rim.size(), shown(plane.centre), 1e3 * plane.departure));
  for (const auto v : rim) s.vertices[v] -= plane.normal.dot(s.vertices[v] - plane.centre) * plane.normal;
  End end;
  const auto middle = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.push_back(plane.centre);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    end.triangles.push_back(static_cast<std::uint32_t>(s.triangles.size()));
    s.triangles.push_back({rim[(k + 1) % rim.size()], rim[k], middle});
    s.region.push_back(SurfaceRegion::wall);
  }
  return end;
}

std::vector<End> namedEnds(const StlSolids& file) {
  std::vector<End> ends;
  for (const SurfaceRegion which : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
    End end{{}, which};
    for (std::uint32_t t = 0; t < file.solid.size(); ++t)
      if (meaning(file.names[file.solid[t]]) == which) end.triangles.push_back(t);
    if (!end.triangles.empty()) ends.push_back(std::move(end));
  }
  return ends;
}

/// Puts the vertices of an end exactly into its plane.
void flatten(TriSurface& s, const End& end) {
  const auto vertices = end.vertices(s);
  const FittedPlane plane = fitPlane(s, vertices);
  if (plane.departure > planarity * end.diameter(s))
    refuse(fmt::format("the end at {} is not planar: off by {:.3g} mm", shown(plane.centre),
                       1e3 * plane.departure));
  for (const auto v : vertices)
    s.vertices[v] -= plane.normal.dot(s.vertices[v] - plane.centre) * plane.normal;
}

/// The two ends, or a refusal that says what was found.
std::vector<End> findEnds(TriSurface& s, std::vector<End> ends, std::size_t rims) {
  if (ends.size() < 2 || rims > 0) {
    std::vector<bool> taken(s.triangles.size(), false);
    for (const End& end : ends)
      for (const auto t : end.triangles) taken[t] = true;
    for (auto& cap : planarCaps(s, surfaceEdges(s)))
      if (std::none_of(cap.begin(), cap.end(), [&](auto t) { return taken[t]; }))
        ends.push_back({std::move(cap), std::nullopt});
  }
  if (ends.size() != 2) {
    std::string where;
    for (std::size_t n = 0; n < std::min<std::size_t>(ends.size(), 6); ++n)
      where += fmt::format("{} {:.4g} mm wide around {}", n == 0 ? ":" : ",", 1e3 * ends[n].diameter(s),
                           shown(fitPlane(s, ends[n].vertices(s)).centre));
    refuse(
        fmt::format("it needs two planar ends, open or closed by a flat cap with a sharp rim, but {} {} "
                    "found ({} of them open){}. Cut the ends straight, close holes, or name the solids of "
                    "the ends inlet and outlet",
                    ends.size(), ends.size() == 1 ? "was" : "were", rims, where));
  }
  return ends;
}

/// Puts the inlet first.
void sortEnds(const TriSurface& s, std::vector<End>& ends) {
  const auto centre = [&](const End& end) { return fitPlane(s, end.vertices(s)).centre; };
  bool swap = false;
  if (ends[0].named || ends[1].named) {
    swap = ends[0].named == SurfaceRegion::outlet || ends[1].named == SurfaceRegion::inlet;
  } else {
    Eigen::Index axis = 0;
    const Vec3 between = centre(ends[1]) - centre(ends[0]);
    between.cwiseAbs().maxCoeff(&axis);
    swap = between[axis] < 0.0;
  }
  if (swap) std::swap(ends[0], ends[1]);
}

void requireSize(const TriSurface& s, const std::vector<End>& ends) {
  const double a = ends[0].diameter(s), b = ends[1].diameter(s);
  const double ratio = std::min(a, b) / std::max(a, b);
  if (ratio * ratio < leastAreaRatio)
    refuse(
        fmt::format("its two planar ends are {:.3g} and {:.3g} mm wide: the smaller looks like a hole, and "
                    "an end is missing",
                    1e3 * a, 1e3 * b));
  for (const double d : {a, b})
    if (!(d >= leastDiameter && d <= largestDiameter))
      refuse(fmt::format("an end is {:.4g} mm wide, not between {:g} and {:g} mm: is the length unit right?",
                         1e3 * d, 1e3 * leastDiameter, 1e3 * largestDiameter));
}

}  // namespace

TriSurface loadLumen(const std::filesystem::path& file, double metresPerUnit) {
  StlSolids read = readStlSolids(file, metresPerUnit);
  TriSurface& s = read.surface;
  if (const SurfaceEdges edges = surfaceEdges(s); edges.crowded > 0)
    refuse(fmt::format("{} edges have more than two triangles: parts of it overlap or meet in one edge",
                       edges.crowded));
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (meaning(read.names[read.solid[t]]) == SurfaceRegion::strut) s.region[t] = SurfaceRegion::strut;
  std::vector<End> ends = namedEnds(read);

  if (const std::size_t pieces = orient(s); pieces != 1)
    refuse(fmt::format("it consists of {} separate pieces; a lumen is one", pieces));
  std::vector<std::vector<std::uint32_t>> rims;
  try {
    rims = openRims(surfaceEdges(s).open);
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  }
  for (const auto& rim : rims) ends.push_back(closeRim(s, rim));
  if (surfaceEdges(s).opposed > 0) refuse("it has only one side, like a Moebius strip");
  if (enclosedVolume(s) < 0.0)
    for (auto& t : s.triangles) std::swap(t[1], t[2]);

  ends = findEnds(s, std::move(ends), rims.size());
  requireSize(s, ends);
  for (const End& end : ends) flatten(s, end);
  sortEnds(s, ends);
  for (const auto t : ends[0].triangles) s.region[t] = SurfaceRegion::inlet;
  for (const auto t : ends[1].triangles) s.region[t] = SurfaceRegion::outlet;
  return s;
}

TriSurface loadLumen(const VesselParameters& vessel) {
  const std::string& unit = vessel.lumenSurfaceUnit;
  return loadLumen(vessel.lumenSurface, unit == "m" ? 1.0 : unit == "mm" ? 1e-3 : 1e-6);
}

double endDiameter(const TriSurface& lumen, SurfaceRegion end) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end) sum += lumen.areaVector(t);
  return 2.0 * std::sqrt(sum.norm() / std::numbers::pi);
}

}  // namespace restenosis
