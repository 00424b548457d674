#include "bridge/flow/foam/MeshMorph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/InnerMotion.h"
#include "bridge/surface/NearestTriangle.h"
#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

/// How far the ends may have moved along the vessel [m], and points of the mesh may be off them.
constexpr double endTolerance = 1e-9;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

bool isSide(SurfaceRegion region) { return region == SurfaceRegion::wall || region == SurfaceRegion::strut; }

/// The lumen's triangles on wall and struts, by their numbers.
std::vector<std::size_t> sidesOf(const TriSurface& lumen) {
  std::vector<std::size_t> sides;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (isSide(lumen.region[t])) sides.push_back(t);
  return sides;
}

/// The lumen's wall and struts.
NearestTriangle sides(const TriSurface& lumen) {
  Triangles triangles;
  for (const std::size_t t : sidesOf(lumen)) triangles.push_back(lumen.triangles[t]);
  return {lumen.vertices, std::move(triangles)};
}

/// The edges around an end, as triangles without width.
NearestTriangle rim(const TriSurface& lumen, const SurfaceEdges& edges, SurfaceRegion end) {
  Triangles around;
  for (const std::size_t t : sidesOf(lumen))
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = edges.beyond[t][k];
      if (beyond == SurfaceEdges::none || lumen.region[beyond] != end) continue;
      const auto a = lumen.triangles[t][k], b = lumen.triangles[t][(k + 1) % 3];
      around.push_back({a, b, b});
    }
  return {lumen.vertices, std::move(around)};
}

/// The faces of the mesh's wall, cut into triangles about their middles.
NearestTriangle wallOf(const PolyMesh& mesh, std::vector<Vec3> points,
                       const std::vector<std::size_t>& wallFaces) {
  Triangles triangles;
  for (const std::size_t f : wallFaces) {
    const auto corners = mesh.face(f);
    Vec3 middle = Vec3::Zero();
    for (const auto p : corners) middle += points[p] / static_cast<double>(corners.size());
    const auto centre = static_cast<std::uint32_t>(points.size());
    points.push_back(middle);
    for (std::size_t k = 0; k < corners.size(); ++k)
      triangles.push_back({static_cast<std::uint32_t>(corners[k]),
                           static_cast<std::uint32_t>(corners[(k + 1) % corners.size()]), centre});
  }
  return {std::move(points), std::move(triangles)};
}

std::vector<std::size_t> facesOf(const PolyMesh& mesh, std::initializer_list<std::string_view> patches) {
  std::vector<std::size_t> faces;
  for (const auto name : patches)
    if (const auto* patch = mesh.patch(name))
      for (std::size_t f = 0; f < patch->faces; ++f) faces.push_back(patch->start + f);
  return faces;
}

/// Marks the points of an end, and throws where they do not lie in its plane.
std::vector<bool> pointsOfEnd(const PolyMesh& mesh, std::string_view patch, double z) {
  std::vector<bool> marked(mesh.points.size(), false);
  const auto faces = facesOf(mesh, {patch});
  if (faces.empty()) throw std::runtime_error(fmt::format("the mesh has no {}", patch));
  for (const std::size_t f : faces)
    for (const auto p : mesh.face(f)) {
      if (!(std::abs(mesh.points[p].z() - z) <= endTolerance))
        throw std::runtime_error(fmt::format("the {} of the mesh is not where that of the lumen is", patch));
      marked[p] = true;
    }
  return marked;
}

/// Largest distance between the mesh's wall and the lumen's, from either to the other [m].
double departure(const PolyMesh& mesh, const std::vector<Vec3>& points,
                 const std::vector<std::size_t>& wallFaces, const TriSurface& lumen,
                 const NearestTriangle& surface) {
  double largest = 0.0;
  for (const std::size_t f : wallFaces) {
    Vec3 middle = Vec3::Zero();
    for (const auto p : mesh.face(f)) middle += points[p] / static_cast<double>(mesh.face(f).size());
    largest = std::max(largest, surface.at(middle).distance);
  }
  const NearestTriangle wall = wallOf(mesh, points, wallFaces);
  std::vector<bool> onSide(lumen.vertices.size(), false);
  for (const std::size_t t : sidesOf(lumen))
    for (const auto v : lumen.triangles[t]) onSide[v] = true;
  for (std::size_t v = 0; v < onSide.size(); ++v)
    if (onSide[v]) largest = std::max(largest, wall.at(lumen.vertices[v]).distance);
  return largest;
}

}  // namespace

MeshMorph morphOnto(const PolyMesh& mesh, const TriSurface& lumen) {
  const auto wallFaces = facesOf(mesh, {"wall", "strut"});
  if (wallFaces.empty()) throw std::runtime_error("the mesh has no wall");
  const auto inlet = pointsOfEnd(mesh, "inlet", lumenEnd(lumen, SurfaceRegion::inlet).z);
  const auto outlet = pointsOfEnd(mesh, "outlet", lumenEnd(lumen, SurfaceRegion::outlet).z);
  const SurfaceEdges edges = surfaceEdges(lumen);
  const NearestTriangle surface = sides(lumen), inletRim = rim(lumen, edges, SurfaceRegion::inlet),
                        outletRim = rim(lumen, edges, SurfaceRegion::outlet);

  std::vector<PointFreedom> freedom(mesh.points.size(), PointFreedom::all);
  std::vector<Vec3> displacement(mesh.points.size(), Vec3::Zero());
  for (std::size_t i = 0; i < freedom.size(); ++i)
    if (inlet[i] || outlet[i]) freedom[i] = PointFreedom::inPlane;
  MeshMorph result;
  for (const std::size_t f : wallFaces)
    for (const auto p : mesh.face(f)) {
      if (freedom[p] == PointFreedom::given) continue;
      const NearestTriangle& target = inlet[p] ? inletRim : outlet[p] ? outletRim : surface;
      displacement[p] = target.at(mesh.points[p]).point - mesh.points[p];
      if (freedom[p] == PointFreedom::inPlane) displacement[p].z() = 0.0;
      freedom[p] = PointFreedom::given;
      result.movement = std::max(result.movement, displacement[p].norm());
    }
  moveInside(mesh, freedom, displacement);
  result.points = mesh.points;
  for (std::size_t i = 0; i < displacement.size(); ++i) result.points[i] += displacement[i];
  result.departure = departure(mesh, result.points, wallFaces, lumen, surface);
  return result;
}

void takeRegions(std::vector<WallFace>& faces, const TriSurface& lumen) {
  const auto numbers = sidesOf(lumen);
  const NearestTriangle surface = sides(lumen);
  for (WallFace& face : faces) face.region = lumen.region[numbers[surface.at(face.centre).triangle]];
}

}  // namespace restenosis
