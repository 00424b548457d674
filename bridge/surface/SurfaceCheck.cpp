#include "bridge/surface/SurfaceCheck.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

constexpr double leastHeight = 1e-4;  ///< over the longest side, below which a triangle is degenerate
constexpr double planarity = 1e-9;    ///< over the length, how far a cap's vertex may be from its plane

bool isFinite(const TriSurface& s, SurfaceReport& report) {
  const bool good =
      std::all_of(s.vertices.begin(), s.vertices.end(), [](const Vec3& v) { return v.allFinite(); });
  if (!good) report.violations.push_back("a vertex is not finite");
  return good;
}

bool isIndexed(const TriSurface& s, SurfaceReport& report) {
  const bool good = s.region.size() == s.triangles.size() &&
                    std::all_of(s.triangles.begin(), s.triangles.end(), [&](const auto& t) {
                      return std::max({t[0], t[1], t[2]}) < s.vertices.size();
                    });
  if (!good)
    report.violations.emplace_back("a triangle names a vertex that does not exist, or has no region");
  return good && !s.triangles.empty();
}

void checkEdges(const TriSurface& s, SurfaceReport& report) {
  const SurfaceEdges edges = surfaceEdges(s);
  const auto say = [&](std::size_t count, fmt::format_string<std::size_t&> what) {
    if (count > 0) report.violations.push_back(fmt::format(what, count));
  };
  say(edges.open.size(), "{} edges have only one triangle (a hole)");
  say(edges.crowded, "{} edges have more than two triangles");
  say(edges.opposed, "{} edges join triangles of opposite orientation");
}

void checkShapes(const TriSurface& s, SurfaceReport& report) {
  std::size_t degenerate = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto& c = s.triangles[t];
    const double longest =
        std::max({(s.vertices[c[0]] - s.vertices[c[1]]).norm(), (s.vertices[c[1]] - s.vertices[c[2]]).norm(),
                  (s.vertices[c[2]] - s.vertices[c[0]]).norm()});
    const bool cap = isEnd(s.region[t]);
    const double doubleArea = 2 * s.areaVector(t).norm();
    if (cap ? doubleArea <= 0 : doubleArea <= leastHeight * longest * longest) ++degenerate;
  }
  if (degenerate) report.violations.push_back(fmt::format("{} triangles are degenerate", degenerate));
}

/// Pieces of the surface with their volumes: one encloses the lumen, the others floating struts.
void checkPieces(const TriSurface& s, SurfaceReport& report) {
  std::vector<std::uint32_t> parent(s.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : s.triangles)
    for (int c = 0; c < 2; ++c) {
      const auto a = root(t[c]), b = root(t[c + 1]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  struct Piece {
    double volume = 0;
    bool onlyStrut = true;
  };
  std::map<std::uint32_t, Piece> pieces;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    Piece& p = pieces[root(s.triangles[t][0])];
    p.volume += s.areaVector(t).dot(s.centre(t)) / 3;
    p.onlyStrut = p.onlyStrut && s.region[t] == SurfaceRegion::strut;
  }
  std::size_t lumens = 0, strange = 0;
  for (const auto& [vertex, piece] : pieces) {
    report.volume += piece.volume;
    if (piece.volume > 0) {
      ++lumens;
    } else if (!piece.onlyStrut) {
      ++strange;
    }
  }
  report.components = pieces.size();
  if (report.volume <= 0)
    report.violations.push_back("the surface is not oriented outwards: its volume is not positive");
  if (lumens > 1) report.violations.push_back(fmt::format("the surface encloses {} separate lumens", lumens));
  if (strange)
    report.violations.push_back(fmt::format("{} detached pieces in the lumen are not struts", strange));
}

void checkEnds(const TriSurface& s, double length, SurfaceReport& report) {
  for (const auto& [region, name, z, direction] : {std::tuple{SurfaceRegion::inlet, "inlet", 0.0, -1.0},
                                                   {SurfaceRegion::outlet, "outlet", length, 1.0}}) {
    double farthest = 0, facing = 0;
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
      if (s.region[t] != region) continue;
      facing += direction * s.areaVector(t).z();
      for (const auto v : s.triangles[t]) farthest = std::max(farthest, std::abs(s.vertices[v].z() - z));
    }
    if (!(facing > 0)) report.violations.push_back(fmt::format("the {} has no area facing out", name));
    if (farthest > planarity * length)
      report.violations.push_back(
          fmt::format("the {} is not planar: a vertex is {:.3g} m off", name, farthest));
  }
}

}  // namespace

std::string SurfaceReport::summary() const { return fmt::format("{}", fmt::join(violations, "; ")); }

SurfaceReport checkSurface(const TriSurface& s, double length) {
  SurfaceReport report;
  if (s.triangles.empty()) report.violations.push_back("the surface is empty");
  if (!isIndexed(s, report) || !isFinite(s, report)) return report;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    report.area[static_cast<std::size_t>(s.region[t])] += s.areaVector(t).norm();
  checkEdges(s, report);
  checkShapes(s, report);
  checkPieces(s, report);
  checkEnds(s, length, report);
  return report;
}

}  // namespace restenosis
