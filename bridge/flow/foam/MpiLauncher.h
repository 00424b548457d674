#pragma once

#include <string>
#include <vector>

namespace restenosis {

/// The variable of the environment that names what starts the processes of MPI, with its options.
inline constexpr const char* launcherVariable = "RESTENOSIS_LAUNCHER";

/// The command that starts a program on several processes, without their number: the words of
/// RESTENOSIS_LAUNCHER, which blanks part, or mpirun where it is not set or empty. It must take `-n N`, as
/// mpirun and Slurm's srun do.
std::vector<std::string> mpiLauncher();

}  // namespace restenosis
