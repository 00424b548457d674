#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// A whole study by Snakemake.
class WholeStudy : public WholeProgram {
 protected:
  void SetUp() override {
    if (std::system("command -v snakemake >/dev/null") != 0) GTEST_SKIP() << "snakemake is not installed";
    scene("tiny", tinyScene);
    writeText(folder / "study.toml", R"(scenes = ["tiny.toml"]
seeds = [1, 2, 3, 4, 5, 6, 7, 8]
columns = ["neointimaThickness_um", "smc"]
days = [1, 4]
[settings]
"scene.step" = "30 min"
[grid]
"cellCycle.g1Mean" = ["12 h", "16 h"]
)");
  }
  std::vector<std::string> start(const std::string& out) const {
    return {RESTENOSIS_SOURCE_DIR "/studies/start", "study.toml", "-o", out, "--program", RESTENOSIS_PROGRAM};
  }
  /// Digest of each run, and what was collected.
  std::map<std::string, std::string> results(const std::string& out) const {
    std::map<std::string, std::string> found{{"curves", readText(folder.path() / out / "curves.csv")},
                                             {"table", readText(folder.path() / out / "table.csv")}};
    for (const auto& entry : fs::directory_iterator(folder.path() / out / "runs"))
      if (entry.path().extension() == ".finished") found[entry.path().filename()] = readText(entry.path());
    return found;
  }
};

TEST_F(WholeStudy, SurvivesTenKillsOfTheEngineAndOfARun) {
  const ProcessEnd reference = Process(start("reference"), folder.path()).wait(patience);
  ASSERT_EXIT_STATUS(reference, 0);
  ASSERT_EQ(results("reference").size(), 2u + 16u);
  EXPECT_TRUE(exists("reference/study.html"));
  std::mt19937 random(20261128);
  std::uniform_real_distribution<double> within(0, reference.seconds / 10);
  const auto nap = [](double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  };
  for (int n = 0; n < 5; ++n) {
    Process study(start("out"), folder.path());
    nap(within(random));
    study.send(n % 2 == 0 ? SIGKILL : SIGINT);
    EXPECT_NE(study.wait(patience).status, 0) << "kill " << n << " of the engine";
  }
  const std::string ofRuns = " -f '[r]un " + (folder / "tiny.toml").string() + "' >/dev/null";
  const auto someRun = [&] { return std::system(("pgrep" + ofRuns).c_str()) == 0; };
  while (someRun()) nap(0.02);  // what a killed engine has left
  for (int n = 0; n < 5; ++n) {
    Process study(start("out"), folder.path());
    while (study.running() && !someRun()) nap(0.02);
    std::system(("pkill -KILL" + ofRuns).c_str());
    EXPECT_NE(study.wait(patience).status, 0) << "kill " << n << " of a run";
  }
  ASSERT_EXIT_STATUS(Process(start("out"), folder.path()).wait(patience), 0);
  EXPECT_EQ(results("out"), results("reference"));
}

}  // namespace
}  // namespace restenosis
