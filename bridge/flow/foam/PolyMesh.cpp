#include "bridge/flow/foam/PolyMesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "bridge/flow/foam/FoamBinary.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

const fs::path meshFolder = "constant/polyMesh";

std::vector<PolyMesh::Patch> patchesOf(std::string_view boundaryFile) {
  std::vector<PolyMesh::Patch> patches;
  for (const foamLog::Patch& patch : foamLog::patches(boundaryFile))
    if (patch.startFace) patches.push_back({patch.name, *patch.startFace, patch.faces});
  return patches;
}

/// Whether every index is one of `count` things.
bool within(const std::vector<std::int32_t>& indices, std::size_t count) {
  return std::ranges::all_of(indices, [&](auto i) { return i >= 0 && static_cast<std::size_t>(i) < count; });
}

/// A cell has faces of its own, so there are no more cells than faces.
bool consistent(const PolyMesh& mesh) {
  const auto& start = mesh.faceStart;
  return !start.empty() && start.front() == 0 && std::ranges::is_sorted(start) &&
         static_cast<std::size_t>(start.back()) == mesh.faceCorners.size() &&
         within(mesh.faceCorners, mesh.points.size()) && mesh.owner.size() == mesh.faces() &&
         mesh.neighbour.size() <= mesh.faces() && within(mesh.owner, mesh.faces()) &&
         within(mesh.neighbour, mesh.faces()) && std::ranges::all_of(mesh.patches, [&](const auto& patch) {
           return patch.start + patch.faces <= mesh.faces();
         });
}

std::string header(std::string_view format, std::string_view kind, std::string_view object) {
  return fmt::format(
      "FoamFile\n{{\n    version     2.0;\n    format      {};\n    class       {};\n"
      "    arch        \"LSB;label=32;scalar=64\";\n    location    \"constant/polyMesh\";\n"
      "    object      {};\n}}\n\n",
      format, kind, object);
}

void writePoints(const fs::path& folder, const std::vector<Vec3>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  atomicWrite(folder / "points", [&](const PieceWriter& write) {
    write(header("binary", "vectorField", "points"));
    write(foamBinaryList(coordinates, 3));
    write("\n");
  });
}

}  // namespace

std::size_t PolyMesh::cells() const {
  std::int32_t last = -1;
  for (const auto* cellsOfFaces : {&owner, &neighbour})
    for (const auto cell : *cellsOfFaces) last = std::max(last, cell);
  return static_cast<std::size_t>(last + 1);
}

const PolyMesh::Patch* PolyMesh::patch(std::string_view name) const {
  const auto found = std::ranges::find(patches, name, &Patch::name);
  return found == patches.end() ? nullptr : &*found;
}

double PolyMesh::patchArea(std::string_view name) const {
  const Patch* of = patch(name);
  double area = 0.0;
  for (std::size_t f = 0; of != nullptr && f < of->faces; ++f) {
    const auto corners = face(of->start + f);
    Vec3 areaVector = Vec3::Zero();
    for (std::size_t k = 2; k < corners.size(); ++k)
      areaVector +=
          0.5 * (points[corners[k - 1]] - points[corners[0]]).cross(points[corners[k]] - points[corners[0]]);
    area += areaVector.norm();
  }
  return area;
}

std::vector<Vec3> PolyMesh::cellCentres() const {
  std::vector<Vec3> sum(cells(), Vec3::Zero());
  std::vector<int> count(sum.size(), 0);
  for (std::size_t f = 0; f < faces(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (const auto p : face(f)) middle += points[p];
    middle /= static_cast<double>(face(f).size());
    const auto add = [&](std::int32_t cell) { sum[cell] += middle, ++count[cell]; };
    add(owner[f]);
    if (f < neighbour.size()) add(neighbour[f]);
  }
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] /= std::max(count[c], 1);
  return sum;
}

PolyMesh readPolyMesh(const fs::path& caseFolder) {
  const fs::path folder = caseFolder / meshFolder;
  return parsePolyMesh(folder, {.points = foamLog::read(folder / "points"),
                                .faces = foamLog::read(folder / "faces"),
                                .owner = foamLog::read(folder / "owner"),
                                .neighbour = foamLog::read(folder / "neighbour"),
                                .boundary = foamLog::read(folder / "boundary")});
}

PolyMesh parsePolyMesh(const fs::path& folder, PolyMeshFiles files) {
  PolyMesh mesh;
  const auto coordinates = FoamBinary(folder / "points", std::move(files.points)).numbers(3);
  mesh.points.resize(coordinates.size() / 3);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] = Vec3(&coordinates[3 * i]);
  FoamBinary faces(folder / "faces", std::move(files.faces));
  mesh.faceStart = faces.labels();
  mesh.faceCorners = faces.labels();
  mesh.owner = FoamBinary(folder / "owner", std::move(files.owner)).labels();
  mesh.neighbour = FoamBinary(folder / "neighbour", std::move(files.neighbour)).labels();
  mesh.patches = patchesOf(files.boundary);
  if (!consistent(mesh))
    throw std::runtime_error(fmt::format("{}: the files do not fit each other", folder.string()));
  return mesh;
}

void copyPolyMesh(const fs::path& fromCase, const fs::path& toCase, const std::vector<Vec3>& points) {
  const fs::path from = fromCase / meshFolder, to = toCase / meshFolder;
  fs::create_directories(to);
  for (const char* file : {"faces", "owner", "neighbour", "boundary"})
    fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
  writePoints(to, points);
}

void writePolyMesh(const fs::path& caseFolder, const PolyMesh& mesh) {
  const fs::path to = caseFolder / meshFolder;
  fs::create_directories(to);
  writePoints(to, mesh.points);
  atomicWrite(to / "faces", header("binary", "faceCompactList", "faces") + foamBinaryList(mesh.faceStart) +
                                "\n" + foamBinaryList(mesh.faceCorners) + "\n");
  for (const auto& [name, cells] : {std::pair{"owner", &mesh.owner}, {"neighbour", &mesh.neighbour}})
    atomicWrite(to / name, header("binary", "labelList", name) + foamBinaryList(*cells) + "\n");
  std::string boundary =
      header("ascii", "polyBoundaryMesh", "boundary") + fmt::format("{}\n(\n", mesh.patches.size());
  for (const auto& patch : mesh.patches)
    boundary += fmt::format(
        "    {}\n    {{\n        type            {};\n        nFaces          {};\n"
        "        startFace       {};\n    }}\n",
        patch.name, patch.name == "wall" ? "wall" : "patch", patch.faces, patch.start);
  atomicWrite(to / "boundary", boundary + ")\n");
}

}  // namespace restenosis
