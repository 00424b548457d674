#include "FoamExecution.h"

#include <unistd.h>

#include <cstdlib>

namespace restenosis {
namespace {

/// A variable that the user's environment may set otherwise.
void setDefault(ExternalProgram& program, const char* variable, const char* value) {
  if (!std::getenv(variable)) program.setEnvironment(variable, value);
}

/// Prepares a program of OpenFOAM, or one that starts such programs.
ExternalProgram inFoamEnvironment(const std::string& name, const FoamExecution& execution) {
  ExternalProgram program(name);
  setDefault(program, "WM_PROJECT_DIR", "/usr/share/openfoam");
  // snappyHexMesh frees and asks again for the same large blocks: glibc keeps them instead of returning them,
  // in large pages, of which few have to be handed out
  setDefault(program, "GLIBC_TUNABLES",
             "glibc.malloc.trim_threshold=1073741824:glibc.malloc.mmap_threshold=1073741824:"
             "glibc.malloc.top_pad=67108864:glibc.malloc.hugetlb=1");
  program.stopWhen(execution.stopRequested);
  return program;
}

/// By variables rather than options, which differ between MPI's makers: others ignore these of Open MPI's.
void setOpenMpiDefaults(ExternalProgram& mpirun) {
  // More ranks than cores, and sets of cores that a container or queue allows, are the user's decision
  setDefault(mpirun, "OMPI_MCA_rmaps_base_oversubscribe", "1");
  setDefault(mpirun, "OMPI_MCA_hwloc_base_binding_policy", "none");
  // Ranks that spin while they wait take the cores from those they wait for, on a machine that others use too
  setDefault(mpirun, "OMPI_MCA_mpi_yield_when_idle", "1");
  if (geteuid() == 0) {
    setDefault(mpirun, "OMPI_ALLOW_RUN_AS_ROOT", "1");
    setDefault(mpirun, "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
  }
}

}  // namespace

ProgramExit runFoam(const std::string& program, const std::vector<std::string>& arguments,
                    const FoamExecution& execution, const std::filesystem::path& folder,
                    const std::filesystem::path& log) {
  return inFoamEnvironment(program, execution).run(arguments, folder, log);
}

ProgramExit runFoamOnRanks(const std::string& program, const std::vector<std::string>& arguments,
                           const FoamExecution& execution, const std::filesystem::path& folder,
                           const std::filesystem::path& log) {
  if (!execution.parallel()) return runFoam(program, arguments, execution, folder, log);
  const ExternalProgram ranked(program);  // named here where it is missing, not in mpirun's words
  ExternalProgram mpirun = inFoamEnvironment("mpirun", execution);
  setOpenMpiDefaults(mpirun);
  std::vector<std::string> words = {"-np", std::to_string(execution.ranks), ranked.path().string(),
                                    "-parallel"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  ProgramExit exit = mpirun.run(words, folder, log);
  // A starter ends like a shell: the status is 128 and the signal that ended one of its processes
  constexpr int firstSignal = 128, signals = 64;
  if (exit.signal == 0 && exit.status > firstSignal && exit.status <= firstSignal + signals)
    exit.signal = exit.status - firstSignal;
  return exit;
}

}  // namespace restenosis
