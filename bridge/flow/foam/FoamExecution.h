#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bridge/system/ExternalProgram.h"

namespace restenosis {

/// How the programs of OpenFOAM run: on how many processes, and until when.
struct FoamExecution {
  int ranks = 1;                                     ///< MPI processes of the mesher and the solver
  const std::atomic<bool>* stopRequested = nullptr;  ///< once true, the program that runs is ended
  /// A program whose log has not grown for so long is ended; none: never.
  std::optional<std::chrono::duration<double>> silenceLimit = {};
  /// Told of each program that is about to run.
  std::function<void(const std::string& program)> onProgram = {};
  bool parallel() const { return ranks > 1; }
};

/// Runs one of OpenFOAM's programs in a case folder and waits for its end.
ProgramExit runFoam(const std::string& program, const std::vector<std::string>& arguments,
                    const FoamExecution& execution, const std::filesystem::path& folder,
                    const std::filesystem::path& log);

/// The same on all ranks, by mpiLauncher(), in a case that has been decomposed; with one rank the same as
/// runFoam. A signal that ended a rank is in ProgramExit::signal. Both throw ProgramMissing and
/// std::runtime_error as ExternalProgram does.
ProgramExit runFoamOnRanks(const std::string& program, const std::vector<std::string>& arguments,
                           const FoamExecution& execution, const std::filesystem::path& folder,
                           const std::filesystem::path& log);

}  // namespace restenosis
