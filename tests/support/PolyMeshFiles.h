#pragma once

#include "bridge/flow/foam/FoamBinary.h"
#include "bridge/flow/foam/PolyMesh.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis::support {

/// The header of a binary OpenFOAM file.
inline std::string foamHeader(const std::string& type) {
  return "// made by a test\nFoamFile\n{\n    format      binary;\n    class       " + type +
         ";\n    arch        \"LSB;label=32;scalar=64\";\n}\n// * * * //\n\n";
}

inline std::string binaryLabels(const std::vector<std::int32_t>& labels) {
  return std::to_string(labels.size()) + "\n(" +
         std::string(reinterpret_cast<const char*>(labels.data()), labels.size() * sizeof(std::int32_t)) +
         ")\n";
}

/// Writes a mesh into constant/polyMesh of a case as OpenFOAM does.
inline void writePolyMesh(const PolyMesh& mesh, const std::filesystem::path& caseFolder) {
  const auto folder = caseFolder / "constant/polyMesh";
  std::filesystem::create_directories(folder);
  writeText(folder / "faces",
            foamHeader("faceCompactList") + binaryLabels(mesh.faceStart) + binaryLabels(mesh.faceCorners));
  writeText(folder / "owner", foamHeader("labelList") + binaryLabels(mesh.owner));
  writeText(folder / "neighbour", foamHeader("labelList") + binaryLabels(mesh.neighbour));
  std::string boundary = foamHeader("polyBoundaryMesh") + std::to_string(mesh.patches.size()) + "\n(\n";
  for (const auto& patch : mesh.patches)
    boundary += "    " + patch.name + "\n    {\n        type            patch;\n        nFaces          " +
                std::to_string(patch.faces) + ";\n        startFace       " + std::to_string(patch.start) +
                ";\n    }\n";
  writeText(folder / "boundary", boundary + ")\n");
  std::vector<double> coordinates;
  for (const Vec3& p : mesh.points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  writeText(folder / "points", foamHeader("vectorField") + foamBinaryList(coordinates, 3) + "\n");
}

}  // namespace restenosis::support
