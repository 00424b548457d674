#include "bridge/app/RankOptions.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "bridge/app/OptionChecks.h"
#include "bridge/app/ThreadCount.h"
#include "bridge/flow/foam/MpiLauncher.h"

namespace restenosis {

void addRankOptions(CLI::App& command, int& ranks) {
  command
      .add_option("--ranks", ranks,
                  "MPI processes of OpenFOAM's mesher and solver (default: 1); changes results within the "
                  "solver's tolerance")
      ->check(countUpTo(mostRanks));
  command
      .add_option_function<std::string>(
          "--launcher", [](const std::string& words) { setenv(launcherVariable, words.c_str(), 1); },
          fmt::format("what starts them, with its options: \"srun --mpi=pmix\", \"mpirun --hostfile hosts\" "
                      "(default: ${}, or mpirun)",
                      launcherVariable))
      ->check(notEmpty("a command that takes -n N, or no such option for the default"));
}

}  // namespace restenosis
