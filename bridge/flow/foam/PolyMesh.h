#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A mesh as the files of an OpenFOAM case hold it, in metres.
struct PolyMesh {
  struct Patch {
    std::string name;
    std::size_t start = 0, faces = 0;
  };
  std::vector<Vec3> points;
  std::vector<std::int32_t> faceStart, faceCorners;  ///< points of face i: faceStart[i] to faceStart[i + 1]
  std::vector<std::int32_t> owner, neighbour;        ///< cells of a face; the inner faces come first
  std::vector<Patch> patches;

  std::size_t faces() const { return faceStart.empty() ? 0 : faceStart.size() - 1; }
  std::size_t cells() const;
  std::span<const std::int32_t> face(std::size_t i) const {
    return std::span(faceCorners).subspan(faceStart[i], faceStart[i + 1] - faceStart[i]);
  }
  /// Null where there is none of this name.
  const Patch* patch(std::string_view name) const;
  /// Sum over the faces of a patch [m^2]; 0 where there is none of this name.
  double patchArea(std::string_view name) const;
  /// Of each cell the mean of its faces' means: inside it, which is all that finding cells needs.
  std::vector<Vec3> cellCentres() const;
};

/// Reads constant/polyMesh of a case, which must be binary with labels of 32 and numbers of 64 bits, as the
/// template and Debian's OpenFOAM write it. Throws std::runtime_error, naming the file, where it is not, or
/// where the parts do not fit each other.
PolyMesh readPolyMesh(const std::filesystem::path& caseFolder);

/// The contents of the files of constant/polyMesh.
struct PolyMeshFiles {
  std::string points, faces, owner, neighbour, boundary;
};

/// The same from what the files hold; `folder` is what messages name.
PolyMesh parsePolyMesh(const std::filesystem::path& folder, PolyMeshFiles files);

/// Makes a case's mesh that of another case, but with these points. Throws WriteFailed or
/// std::filesystem::filesystem_error where that fails.
void copyPolyMesh(const std::filesystem::path& fromCase, const std::filesystem::path& toCase,
                  const std::vector<Vec3>& points);

/// Writes constant/polyMesh of a case; its patch `wall` is a wall. Throws WriteFailed or
/// std::filesystem::filesystem_error where that fails.
void writePolyMesh(const std::filesystem::path& caseFolder, const PolyMesh& mesh);

}  // namespace restenosis
