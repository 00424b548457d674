#include "bridge/flow/foam/FoamExecution.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "bridge/flow/foam/FoamEnvironment.h"
#include "bridge/flow/foam/MpiLauncher.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// A variable that the user's environment may set otherwise.
void setDefault(ExternalProgram& program, const char* variable, const char* value) {
  if (!std::getenv(variable) || isForOtherFoamCases(variable)) program.setEnvironment(variable, value);
}

/// Prepares a program of OpenFOAM, found at `foam`, or the starter of such programs, to run in a case.
ExternalProgram prepared(ExternalProgram program, const fs::path& foam, const FoamExecution& execution,
                         const fs::path& folder) {
  setFoamEnvironment(program, folder);
  program.setEnvironment("WM_PROJECT_DIR", foamProjectFolder(foam));
  // snappyHexMesh frees and asks again for the same large blocks: glibc keeps them instead of returning them,
  // in large pages, of which few have to be handed out
  setDefault(program, "GLIBC_TUNABLES",
             "glibc.malloc.trim_threshold=1073741824:glibc.malloc.mmap_threshold=1073741824:"
             "glibc.malloc.top_pad=67108864:glibc.malloc.hugetlb=1");
  program.stopWhen(execution.stopRequested);
  if (execution.silenceLimit) program.stopWhenSilentFor(*execution.silenceLimit);
  if (execution.onProgram) execution.onProgram(foam.filename().string());
  return program;
}

/// By variables rather than options, which differ between MPI's makers: others ignore these of Open MPI's.
void setOpenMpiDefaults(ExternalProgram& launcher) {
  // More ranks than cores, and sets of cores that a container or queue allows, are the user's decision
  setDefault(launcher, "OMPI_MCA_rmaps_base_oversubscribe", "1");
  setDefault(launcher, "OMPI_MCA_hwloc_base_binding_policy", "none");
  // Ranks that spin while they wait take the cores from those they wait for, on a machine that others use too
  setDefault(launcher, "OMPI_MCA_mpi_yield_when_idle", "1");
  if (geteuid() == 0) {
    setDefault(launcher, "OMPI_ALLOW_RUN_AS_ROOT", "1");
    setDefault(launcher, "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
  }
}

/// What MPI's processes share lies in the case instead of in /dev/shm and /tmp, where whatever kills all of
/// them leaves it for good.
class SharedFiles {
 public:
  SharedFiles(ExternalProgram& launcher, const fs::path& folder) : folder_(folder / name) {
    fs::remove_all(folder_);  // of a run that was killed
    fs::create_directory(folder_);
    const std::string seen = std::string("/proc/self/cwd/") + name;  // short, and without odd characters
    launcher.setEnvironment("OMPI_MCA_orte_tmpdir_base", seen);
    launcher.setEnvironment("OMPI_MCA_btl_vader_backing_directory", seen);
  }
  ~SharedFiles() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  SharedFiles(const SharedFiles&) = delete;
  SharedFiles& operator=(const SharedFiles&) = delete;

 private:
  static constexpr const char* name = "mpi";
  fs::path folder_;
};

}  // namespace

ProgramExit runFoam(const std::string& program, const std::vector<std::string>& arguments,
                    const FoamExecution& execution, const fs::path& folder, const fs::path& log) {
  const ExternalProgram foam(program);
  return prepared(foam, foam.path(), execution, folder).run(arguments, folder, log);
}

ProgramExit runFoamOnRanks(const std::string& program, const std::vector<std::string>& arguments,
                           const FoamExecution& execution, const fs::path& folder, const fs::path& log) {
  if (!execution.parallel()) return runFoam(program, arguments, execution, folder, log);
  const ExternalProgram ranked(program);  // named here where it is missing, not in the launcher's words
  std::vector<std::string> words = mpiLauncher();
  ExternalProgram launcher = prepared(ExternalProgram(words.front()), ranked.path(), execution, folder);
  words.erase(words.begin());
  setOpenMpiDefaults(launcher);
  launcher.signalledAtDeath(SIGTERM);  // it then ends its processes, however they hang
  const SharedFiles shared(launcher, folder);
  // mpirun gives its processes a PWD of its own
  for (const std::string& word :
       {std::string("-n"), std::to_string(execution.ranks), std::string("/usr/bin/env"),
        "PWD=" + foamWorkingFolder(folder), ranked.path().string(), std::string("-parallel")})
    words.push_back(word);
  words.insert(words.end(), arguments.begin(), arguments.end());
  ProgramExit exit = launcher.run(words, folder, log);
  // A starter ends like a shell: the status is 128 and the signal that ended one of its processes
  constexpr int firstSignal = 128, signals = 64;
  if (exit.signal == 0 && exit.status > firstSignal && exit.status <= firstSignal + signals)
    exit.signal = exit.status - firstSignal;
  return exit;
}

}  // namespace restenosis
