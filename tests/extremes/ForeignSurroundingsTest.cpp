#include <thread>

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// A short tube with OpenFOAM: what it needs of its surroundings is what every flow needs.
constexpr std::string_view tubeScene = R"([scene]
duration = "1 h"
step = "1 h"
fidelity = "draft"

[vessel]
length = "0.4 mm"
lumenDiameter = "1.2 mm"
wallThickness = "0.1 mm"

[flow]
backend = "foam"

[output]
pictures = false
)";

/// OpenFOAM's programs where a user may have everything set for something else.
class ForeignSurroundings : public WholeProgram {
 protected:
  /// A run in a folder, with its results in `out` there.
  ProcessEnd runIn(const fs::path& at, int ranks, const Environment& environment = {},
                   std::vector<std::string> starter = {}) const {
    fs::create_directories(at);
    writeText(at / "tube.toml", std::string(tubeScene));
    std::ranges::copy(command({"run", "tube.toml", "-o", "out", "--ranks", std::to_string(ranks)}),
                      std::back_inserter(starter));
    return Process(starter, at, environment).wait(patience);
  }
  static nlohmann::json finalOf(const fs::path& at) {
    return nlohmann::json::parse(readText(at / "out/summary.json"))["final"];
  }
};

/// Blanks, quotes and what a shell or a dictionary would take for its own.
const std::string oddName = "a b  \"c\" 'd' $HOME #e{(;\\\xc3\xa4\n\t*";

TEST_F(ForeignSurroundings, AWorkingFolderMayHaveAnyName) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const fs::path odd = folder / oddName, plain = folder / "plain";
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(ranks);
    ASSERT_EXIT_STATUS(runIn(plain, ranks), 0);
    ASSERT_EXIT_STATUS(runIn(odd, ranks, {{"PWD", "/"}, {"HOME", odd}, {"TMPDIR", odd}}), 0);
    EXPECT_EQ(finalOf(odd), finalOf(plain));
  }
  // Both methods side by side
  const auto stressesIn = [&](const fs::path& at) {
    Process compare(command({"compare", "out", "-o", "compared", "--set", "lbm.dx=100 um"}), at);
    EXPECT_EXIT_STATUS(compare.wait(patience), 0);
    return nlohmann::json::parse(readText(at / "compared/compare.json"))["wss"]["wall"];
  };
  EXPECT_EQ(stressesIn(odd), stressesIn(plain));
  // What is left can be run by hand, too
  const fs::path left = odd / "out/flow/0";
  ASSERT_EXIT_STATUS(Process({(left / "Allrun").string()}, left).wait(patience), 0);
}

TEST_F(ForeignSurroundings, SettingsOfOtherCasesChangeNothing) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const fs::path home = folder / "home";
  fs::create_directories(home / ".OpenFOAM/1912");
  fs::create_directories(home / ".openmpi");
  for (const char* file : {"controlDict", "1912/controlDict", "cellModels"})
    writeText(home / ".OpenFOAM" / file, "OptimisationSwitches { fileHandler collated; } {");
  writeText(home / ".openmpi/mca-params.conf", "btl = none\n");
  const Environment others = {{"HOME", home},
                              {"FOAM_FILEHANDLER", "collated"},
                              {"FOAM_ABORT", "true"},
                              {"FOAM_CONTROLDICT", "{"},
                              {"FOAM_SETNAN", "true"},
                              {"WM_PROJECT_DIR", "/nonexistent"},
                              {"WM_PROJECT_SITE", home / ".OpenFOAM"},
                              {"MPI_BUFFER_SIZE", "10"}};
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(ranks);
    ASSERT_EXIT_STATUS(runIn(folder / "plain", ranks), 0);
    ASSERT_EXIT_STATUS(runIn(folder / "other", ranks, others), 0);
    EXPECT_EQ(finalOf(folder / "other"), finalOf(folder / "plain"));
  }
}

TEST_F(ForeignSurroundings, TheProgramMayBePartOfAnMpiJobItself) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const ProcessEnd end =
      runIn(folder / "job", 2, {{"OMPI_ALLOW_RUN_AS_ROOT", "1"}, {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"}},
            {"/usr/bin/env", "mpirun", "-np", "1"});
  ASSERT_EXIT_STATUS(end, 0);
}

/// What MPI's processes share, while they run.
bool sharesIn(const fs::path& at) {
  std::error_code gone;
  for (auto entry = fs::recursive_directory_iterator(at, gone); entry != fs::recursive_directory_iterator();
       entry.increment(gone))
    if (entry->path().filename().string().starts_with("vader_segment")) return true;
  return false;
}

TEST_F(ForeignSurroundings, AKilledRunLeavesNothingOutsideOfItsResults) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const fs::path at = folder / "killed", temporary = folder / "temporary";
  fs::create_directories(at);
  fs::create_directories(temporary);
  writeText(at / "tube.toml", std::string(tubeScene));
  const auto endless = command({"run", "tube.toml", "-o", "out", "--ranks", "2", "--set",
                                "foam.tolerance=1e-30", "--set", "foam.iterations=1000000"});
  Process process(endless, at, {{"TMPDIR", temporary}});
  const fs::path flow = at / "out/flow/0";
  while (process.running() && !(fs::exists(flow / "log.simpleFoam") && sharesIn(flow / "mpi")))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.send(SIGKILL);
  EXPECT_EQ(process.wait(patience).signal, SIGKILL);
  EXPECT_TRUE(fs::is_empty(temporary));

  // All of it is gone once the flow is solved again
  const auto words = command({"run", "tube.toml", "-o", "out", "--ranks", "2", "--resume"});
  ASSERT_EXIT_STATUS(Process(words, at, {{"TMPDIR", temporary}}).wait(patience), 0);
  EXPECT_FALSE(fs::exists(flow / "mpi"));
  EXPECT_TRUE(fs::is_empty(temporary));
}

}  // namespace
}  // namespace restenosis
