#include "FoamRequirements.h"

#include <fmt/format.h>

#include "ExternalProgram.h"

namespace restenosis {

std::string missingProgramText(const std::string& program) {
  const bool mpi = program == "mpirun";
  return fmt::format(
      "the {} program '{}' is not on the PATH; it is part of the Debian package '{package}' (apt "
      "install {package})",
      mpi ? "MPI" : "OpenFOAM", program, fmt::arg("package", mpi ? "openmpi-bin" : "openfoam"));
}

std::string missingFoamProgram(int ranks) {
  std::vector<std::string> programs{"blockMesh", "snappyHexMesh", "checkMesh", "simpleFoam"};
  if (ranks > 1)
    programs.insert(programs.end(), {"decomposePar", "reconstructParMesh", "reconstructPar", "mpirun"});
  for (const std::string& program : programs) try {
      ExternalProgram{program};
    } catch (const ProgramMissing&) {
      return missingProgramText(program);
    }
  return "";
}

std::string unusableFoamPath(const std::filesystem::path& folder) {
  const std::string path = std::filesystem::weakly_canonical(std::filesystem::absolute(folder)).string();
  const auto at = path.find_first_of(" \t\n\"'");
  if (at == std::string::npos) return "";
  return fmt::format(
      "{}: OpenFOAM works in no folder with {} in its path", path,
      path[at] == '"' || path[at] == '\'' ? fmt::format("the character {}", path[at]) : "a blank");
}

}  // namespace restenosis
