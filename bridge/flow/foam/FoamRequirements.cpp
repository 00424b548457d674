#include "bridge/flow/foam/FoamRequirements.h"

#include <fmt/format.h>

#include <vector>

#include "bridge/flow/foam/FoamEnvironment.h"
#include "bridge/flow/foam/MpiLauncher.h"
#include "bridge/system/ExternalProgram.h"

namespace restenosis {

std::string missingProgramText(const std::string& program) {
  if (const std::string launcher = mpiLauncher().front(); program == launcher && launcher != "mpirun")
    return fmt::format("'{}', which is to start OpenFOAM's processes, is not on the PATH", program);
  const bool mpi = program == "mpirun";
  return fmt::format(
      "the {} program '{}' is not on the PATH; it is part of the Debian package '{package}' (apt "
      "install {package})",
      mpi ? "MPI" : "OpenFOAM", program, fmt::arg("package", mpi ? "openmpi-bin" : "openfoam"));
}

std::string missingFoamProgram(int ranks) {
  std::vector<std::string> programs{"blockMesh", "snappyHexMesh", "checkMesh", "simpleFoam"};
  const std::string launcher = mpiLauncher().front();
  if (ranks > 1)
    programs.insert(programs.end(), {"decomposePar", "reconstructParMesh", "reconstructPar", launcher});
  for (const std::string& program : programs) try {
      const ExternalProgram found(program);
      if (program != launcher) foamProjectFolder(found.path());
    } catch (const ProgramMissing&) {
      return missingProgramText(program);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  return "";
}

}  // namespace restenosis
