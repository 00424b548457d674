#pragma once

#include <filesystem>
#include <vector>

#include "bridge/flow/foam/PolyMesh.h"

namespace restenosis {

/// A case that has been solved: mesh and flow, in the case's units.
struct FoamSolution {
  PolyMesh mesh;
  std::vector<double> velocity, pressure;  ///< by cell; three numbers and one
};

/// Reads the mesh of a case and the flow of its last iteration. Throws std::runtime_error where one is
/// missing, not binary, or does not fit the other.
FoamSolution readFoamSolution(const std::filesystem::path& caseFolder);

/// The files that this reads, relative to the case. Throws std::runtime_error where no iteration is there.
std::vector<std::filesystem::path> foamSolutionFiles(const std::filesystem::path& caseFolder);

/// A flow that another is started from: each cell of the new mesh starts with the values of the nearest
/// place.
class FoamStart {
 public:
  /// `solution`, which must outlive this, on a mesh that may have moved since: its cells are at `centres`.
  FoamStart(const FoamSolution& solution, std::vector<Vec3> centres);
  /// Puts the values into 0/U, at the inlet as well, and 0/p of a case, or of a rank's part of it, whose mesh
  /// is there and whose fields are the template's. Throws std::runtime_error where they cannot be read,
  /// WriteFailed where they cannot be written.
  void write(const std::filesystem::path& part) const;

 private:
  const FoamSolution& solution_;
  std::vector<Vec3> centres_;
};

}  // namespace restenosis
