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
  std::uniform_real_distribution<double> within(0, 1);
  int ended = 0;
  for (int n = 0; n < 10; ++n) {
    Process study(start("out"), folder.path());
    const double age = 2 + within(random) * reference.seconds / 25;
    while (study.running() && study.age() < age) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (n % 3 == 0) study.send(SIGKILL);
    if (n % 3 == 1) study.send(SIGINT);
    if (n % 3 == 2) std::system(("pkill -KILL -f 'run " + (folder / "tiny.toml").string() + "'").c_str());
    const ProcessEnd end = study.wait(patience);
    if (end.status != 0) ++ended;
  }
  EXPECT_GE(ended, 6) << "the machine was much faster than when the reference ran";
  ASSERT_EXIT_STATUS(Process(start("out"), folder.path()).wait(patience), 0);
  EXPECT_EQ(results("out"), results("reference"));
}

}  // namespace
}  // namespace restenosis
