#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/EnvironmentVariable.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;
namespace fs = std::filesystem;

struct Failure {
  std::string message;  ///< empty where the flow did not fail
  fs::path log;
};

Failure failure(const FoamSettings& settings, const FoamExecution& execution, const fs::path& folder) {
  try {
    FoamBackend(settings, execution).solve(tube(vesselRadius, vesselLength), vesselConditions(), folder);
  } catch (const FlowFailed& error) {
    return {error.what(), error.log};
  } catch (const WriteFailed& error) {
    return {error.what(), {}};
  }
  return {};
}

/// A solve that does not end by itself within the time of a test.
FoamSettings endless() {
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.tolerance = 1e-30;
  settings.iterations = 1000000;
  return settings;
}

/// The processes of this name that work in a folder or below it.
std::vector<pid_t> processesIn(const fs::path& folder, const std::string& name) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::error_code error;
    const auto cwd = fs::read_symlink(entry.path() / "cwd", error);
    if (!error && cwd.string().starts_with(folder.string()) && readText(entry.path() / "comm") == name + '\n')
      found.push_back(std::stoi(entry.path().filename().string()));
  }
  return found;
}

/// Whether the programs of a folder end within a while: mpirun may be gone a moment before the ranks it has
/// killed.
bool allEnd(const fs::path& folder, const std::string& name) {
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!processesIn(folder, name).empty()) {
    if (std::chrono::steady_clock::now() > last) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// Calls `act` again and again while a log holds some words, until it is destroyed.
class During {
 public:
  template <class Act>
  During(const fs::path& log, const std::string& words, Act act)
      : thread_([this, log, words, act] {
          while (!done_) {
            if (readText(log).find(words) != std::string::npos) act();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
          }
        }) {}
  ~During() {
    done_ = true;
    thread_.join();
  }
  During(const During&) = delete;
  During& operator=(const During&) = delete;

 private:
  std::atomic<bool> done_{false};
  std::thread thread_;
};

/// In a log of simpleFoam: it is in mid-solve.
const std::string midSolve = "\nTime = 5\n";

class FoamExecutionFaults : public ::testing::TestWithParam<int> {};

TEST_P(FoamExecutionFaults, solverKilledInMidSolveIsNamedWithItsLog) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  Failure found;
  {
    const During killing(scratch / "case/log.simpleFoam", midSolve, [&] {
      const auto solvers = processesIn(scratch.path(), "simpleFoam");
      if (!solvers.empty()) kill(solvers.back(), SIGKILL);
    });
    found = failure(endless(), {.ranks = GetParam()}, scratch / "case");
  }
  EXPECT_SAYS(found.message, "simpleFoam was killed from outside, or by the system because memory ran out");
  EXPECT_EQ(found.message.find("first attempt"), std::string::npos);
  EXPECT_EQ(found.log, scratch / "case/log.simpleFoam");
  EXPECT_TRUE(fs::exists(found.log));
  EXPECT_TRUE(allEnd(scratch.path(), "simpleFoam"));
}

TEST_P(FoamExecutionFaults, requestToStopEndsTheSolveAtOnceAndForGood) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  std::atomic<bool> stop{false};
  Failure found;
  {
    const During stopping(scratch / "case/log.simpleFoam", midSolve, [&] { stop = true; });
    found = failure(endless(), {.ranks = GetParam(), .stopRequested = &stop}, scratch / "case");
  }
  EXPECT_SAYS(found.message, "simpleFoam was interrupted");
  EXPECT_EQ(found.message.find("first attempt"), std::string::npos);
  EXPECT_TRUE(allEnd(scratch.path(), "simpleFoam"));
}

INSTANTIATE_TEST_SUITE_P(Ranks, FoamExecutionFaults, ::testing::Values(1, 2));

/// From when on files end at a size, and what cannot be written then.
struct DiskFull {
  const char* log;  ///< exists; programs that start from now on inherit the limit
  rlim_t bytes;
  const char* words;    ///< of the step that meets the limit
  const char* orWords;  ///< or of the one before, where that had not started yet
  friend void PrintTo(const DiskFull& disk, std::ostream* out) { *out << disk.words; }
};
class FoamDiskFull : public ::testing::TestWithParam<DiskFull> {};

TEST_P(FoamDiskFull, isNoResultAndNamesTheStep) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  std::unique_ptr<FileSizeLimit> disk;
  Failure found;
  {
    const During filling(scratch.path() / GetParam().log, "", [&] {
      if (!disk && fs::exists(scratch.path() / GetParam().log))
        disk = std::make_unique<FileSizeLimit>(GetParam().bytes);
    });
    found = failure(FoamSettings::forFidelity("draft"), {}, scratch / "case");
  }
  disk.reset();
  EXPECT_TRUE(found.message.find(GetParam().words) != std::string::npos ||
              found.message.find(GetParam().orWords) != std::string::npos)
      << found.message;
}

INSTANTIATE_TEST_SUITE_P(
    Stages, FoamDiskFull,
    ::testing::Values(DiskFull{"", 20000, "lumen.stl: File too large: make room",
                               "lumen.stl: File too large"},
                      DiskFull{"case/log.blockMesh", 300000, "snappyHexMesh", "blockMesh"},
                      DiskFull{"case/log.checkMesh", 100000, "simpleFoam", "checkMesh"}));

/// A folder for the PATH with programs that do nothing, but for snappyHexMesh, which is this shell script.
fs::path programsIn(const fs::path& bin, const std::string& snappyHexMesh) {
  fs::create_directories(bin);
  for (const char* program : {"blockMesh", "decomposePar", "snappyHexMesh"}) {
    writeText(bin / program,
              std::string("#!/bin/sh\n") + (program == std::string("snappyHexMesh") ? snappyHexMesh : ""));
    fs::permissions(bin / program, fs::perms::owner_all);
  }
  return bin;
}

TEST(FoamExecution, ranksThatHangAreNamedWithTheirLogAndEnded) {
  RESTENOSIS_NEEDS_OPENFOAM();  // of which MPI is a part
  const TemporaryFolder scratch;
  // One that does not even heed the request to end
  const auto bin = programsIn(scratch / "bin", "trap '' TERM\necho here\nsleep 100000\nsleep 100000\n");
  const EnvironmentVariable path("PATH", (bin.string() + ":/usr/bin:/bin").c_str());
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.silenceLimit = 1;  // [s]
  const auto found = failure(settings, {.ranks = 2}, scratch / "case");
  EXPECT_SAYS(found.message, "snappyHexMesh hangs: its log has not grown for");
  EXPECT_EQ(found.message.find("first attempt"), std::string::npos);
  EXPECT_EQ(found.log, scratch / "case/log.snappyHexMesh");
  for (const char* name : {"sleep", "snappyHexMesh", "mpirun"})
    EXPECT_TRUE(allEnd(scratch.path(), name)) << name;
}

TEST(FoamExecution, missingMpirunNamesItsPackage) {
  const TemporaryFolder scratch;
  const EnvironmentVariable path("PATH", programsIn(scratch / "bin", "").c_str());
  const auto found = failure(FoamSettings::forFidelity("draft"), {.ranks = 2}, scratch / "case");
  EXPECT_SAYS(found.message, "'mpirun'");
  EXPECT_SAYS(found.message, "apt install openmpi-bin");
}

}  // namespace
}  // namespace restenosis
