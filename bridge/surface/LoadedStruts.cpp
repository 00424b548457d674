#include "bridge/surface/LoadedStruts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/NamedSolids.h"
#include "bridge/surface/SolidNames.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceCrossings.h"
#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/SurfacePieces.h"

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

[[noreturn]] void reject(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
}

/// A lumen with its stent in one file, say: its wall would become strut.
void requireStrutsOnly(const SurfaceSolids& solids, const std::filesystem::path& file) {
  std::vector<std::uint32_t> struts, others;
  for (std::uint32_t n = 0; n < solids.names.size(); ++n) {
    const auto said = meaningsOf(solids.names[n]);
    if (said.empty() || std::ranges::find(solids.solid, n) == solids.solid.end()) continue;
    (std::ranges::find(said, SurfaceRegion::strut) != said.end() ? struts : others).push_back(n);
  }
  if (struts.empty() || others.empty()) return;
  reject(file, fmt::format(
                   "{} {} named as struts, {} {} not; the file holds the struts alone: take the others out, "
                   "or rename them",
                   shownSolids(solids.names, struts), struts.size() == 1 ? "is" : "are",
                   shownSolids(solids.names, others), others.size() == 1 ? "is" : "are"));
}

/// Makes all of it strut with normals outwards, and returns the pieces.
std::vector<StrutPiece> makeStruts(SurfaceSolids& solids, const std::filesystem::path& file) {
  requireStrutsOnly(solids, file);
  TriSurface& s = solids.surface;
  const std::vector<std::uint32_t> pieceOf = orientPieces(s);
  const SurfaceEdges edges = surfaceEdges(s);
  if (edges.crowded > 0)
    reject(file,
           fmt::format("{} more than two triangles: {}. Parts of the struts' surface overlap or meet in one "
                       "edge there; make them one surface, or separate closed ones without common edges",
                       edges.crowded == 1 ? "an edge has" : fmt::format("{} edges have", edges.crowded),
                       shownEdges(s, edges.crowdedEdges)));
  if (!edges.open.empty())
    reject(file, fmt::format(
                     "the struts' surface is not closed: {} only one triangle, {}. Allowed are closed "
                     "surfaces: close the holes there",
                     edges.open.size() == 1 ? "an edge has" : fmt::format("{} edges have", edges.open.size()),
                     shownEdges(s, edges.open)));
  if (edges.opposed > 0) reject(file, "the struts' surface has only one side, like a Moebius strip");
  if (const SurfaceCrossings crossings = surfaceCrossings(s, pieceOf); crossings.edges > 0)
    reject(file,
           fmt::format("a piece of the struts' surface passes through itself, at {}; allowed are pieces that "
                       "do not, which may overlap each other",
                       shownPlace(crossings.place)));
  std::vector<StrutPiece> pieces = measure(s, pieceOf);
  for (const StrutPiece& piece : pieces)
    if (std::abs(piece.volume) <= flatVolume * std::pow(piece.area / 6, 1.5))
      reject(file, fmt::format("a piece of the struts' surface, at {}, encloses nothing: it is flat",
                               shownPlace(piece.origin)));
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (pieces[pieceOf[t]].volume < 0) std::swap(s.triangles[t][1], s.triangles[t][2]);
  s.region.assign(s.triangles.size(), SurfaceRegion::strut);
  return pieces;
}

}  // namespace

TriSurface loadStruts(const std::filesystem::path& file, double metresPerUnit) {
  SurfaceSolids solids = readSurfaceSolids(file, metresPerUnit);
  makeStruts(solids, file);
  return std::move(solids.surface);
}

std::string describeStruts(const std::filesystem::path& file, double metresPerUnit) {
  SurfaceSolids solids = readSurfaceSolids(file, metresPerUnit);
  double volume = 0;
  const auto pieces = makeStruts(solids, file);
  for (const StrutPiece& piece : pieces) volume += std::abs(piece.volume);
  std::vector<std::uint32_t> all(solids.surface.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const std::string from = shownSolids(solids, all);
  return fmt::format("{} closed {} of {:.4g} mm3, {}{}", pieces.size(),
                     pieces.size() == 1 ? "piece" : "pieces", 1e9 * volume, shownExtent(solids.surface, all),
                     from.empty() ? "" : ": " + from);
}

}  // namespace restenosis
