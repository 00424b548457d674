#include "LoadedStruts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "LumenRefusal.h"
#include "StlFile.h"
#include "SurfaceCrossings.h"
#include "SurfaceEnds.h"
#include "SurfacePieces.h"

namespace restenosis {
namespace {

/// Volume of a piece, over that of a cube of the same area, below which it is flat (assumed).
constexpr double flatVolume = 1e-9;

/// Volume [m^3] and area [m^2] of a piece, and one of its vertices.
struct StrutPiece {
  Vec3 origin = Vec3::Zero();
  double volume = 0, area = 0;
};

std::vector<StrutPiece> measure(const TriSurface& s, const std::vector<std::uint32_t>& pieceOf) {
  std::vector<StrutPiece> pieces(1 + std::ranges::max(pieceOf));
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    StrutPiece& piece = pieces[pieceOf[t]];
    if (piece.area == 0) piece.origin = s.vertices[s.triangles[t][0]];
    piece.volume += (s.vertices[s.triangles[t][0]] - piece.origin).dot(s.areaVector(t)) / 3;
    piece.area += s.areaVector(t).norm();
  }
  return pieces;
}

}  // namespace

TriSurface loadStruts(const std::filesystem::path& file, double metresPerUnit) {
  TriSurface s = readStlSolids(file, metresPerUnit).surface;
  const auto refuse = [&file](const std::string& why) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  };
  const std::vector<std::uint32_t> pieceOf = orientPieces(s);
  const SurfaceEdges edges = surfaceEdges(s);
  if (edges.crowded > 0)
    refuse(
        fmt::format("{} edges have more than two triangles: parts of the struts' surface overlap or meet "
                    "in one edge; make them one surface, or separate closed ones without common edges",
                    edges.crowded));
  if (!edges.open.empty())
    refuse(
        fmt::format("the struts' surface is not closed: {} edges have only one triangle, the first at {}; "
                    "allowed are closed surfaces",
                    edges.open.size(), shownPlace(s.vertices[edges.open.front()[0]])));
  if (edges.opposed > 0) refuse("the struts' surface has only one side, like a Moebius strip");
  if (const SurfaceCrossings crossings = surfaceCrossings(s, pieceOf); crossings.edges > 0)
    refuse(
        fmt::format("a piece of the struts' surface passes through itself, at {}; allowed are pieces that do "
                    "not, which may overlap each other",
                    shownPlace(crossings.place)));
  const std::vector<StrutPiece> pieces = measure(s, pieceOf);
  for (const StrutPiece& piece : pieces)
    if (std::abs(piece.volume) <= flatVolume * std::pow(piece.area / 6, 1.5))
      refuse(fmt::format("a piece of the struts' surface, at {}, encloses nothing: it is flat",
                         shownPlace(piece.origin)));
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (pieces[pieceOf[t]].volume < 0) std::swap(s.triangles[t][1], s.triangles[t][2]);
  s.region.assign(s.triangles.size(), SurfaceRegion::strut);
  return s;
}

}  // namespace restenosis
