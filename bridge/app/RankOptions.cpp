#include "bridge/app/RankOptions.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "bridge/app/OptionChecks.h"
#include "bridge/app/ThreadCount.h"
#include "bridge/coupling/CostForecast.h"
#include "bridge/flow/foam/MpiLauncher.h"

namespace restenosis {
void addRankOptions(CLI::App& command, int& ranks) {
  command
      .add_option(
          "--ranks", ranks,
          fmt::format("MPI processes of OpenFOAM's mesher and solver (default: 2 where some {:.0f} cells or "
                      "more are expected, else 1); changes results within the solver's tolerance",
                      cellsWorthTwoRanks))
      ->check(countUpTo(mostRanks));
  command
      .add_option_function<std::string>(
          "--launcher", [](const std::string& words) { setenv(launcherVariable, words.c_str(), 1); },
          fmt::format("what starts them, with its options: \"srun --mpi=pmix\", \"mpirun --hostfile hosts\" "
                      "(default: ${}, or mpirun)",
                      launcherVariable))
      ->check(notEmpty("a command that takes -n N, or no such option for the default"));
}

int rankCount(const Scene& scene, int askedFor) {
  return askedFor > 0 ? askedFor : scene.flow ? usualRanks(scene) : 1;
}

}  // namespace restenosis
