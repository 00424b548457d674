#include "bridge/flow/foam/FoamRequirements.h"

#include <fmt/format.h>

#include <vector>

#include "bridge/flow/foam/FoamEnvironment.h"
#include "bridge/system/ExternalProgram.h"

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
      const ExternalProgram found(program);
      if (program != "mpirun") foamProjectFolder(found.path());
    } catch (const ProgramMissing&) {
      return missingProgramText(program);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  return "";
}

}  // namespace restenosis
