#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>
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

/// The study of uncertainty, of a model whose indices are known.
class Uncertainty : public WholeProgram {};

TEST_F(Uncertainty, ALinearModelHasItsExactIndices) {
  if (std::system("/usr/bin/python3 -c 'import openturns' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-openturns is not installed";
  fs::create_directories(folder / "studies");
  for (const char* of : {"workflow", "uncertainty"})
    fs::copy(std::string(RESTENOSIS_SOURCE_DIR "/studies/") + of, folder / "studies" / of,
             fs::copy_options::recursive);
  const fs::path study = folder / "studies/uncertainty";
  // 2 and 3 times where the value lies in its range, from -1 to 1: variances as 4 to 9
  std::string runs = "run,status\n",
              curves = "run,day,relativeIntimaArea,neointimaThickness_um,intimaMatrixShare\n";
  std::istringstream points(readText(study / "points.csv"));
  std::string line;
  std::getline(points, line);
  for (int n = 1; n <= 300 && std::getline(points, line); ++n) {
    const std::size_t comma = line.find(',');
    const double value =
        2 * (std::stod(line) - 1.5) / 0.3 + 3 * (std::stod(line.substr(comma + 1)) - 0.045) / 0.015;
    const std::string run = fmt::format("ring_point{:04}", n);
    runs += run + ",finished\n";
    curves += fmt::format("{0},0,0,0,0\n{0},28,{1},{1},{1}\n", run, value);
  }
  writeText(study / "kept/runs.csv", runs);
  writeText(study / "kept/curves.csv", curves);
  fs::create_directories(folder / "results/studies/uncertainty");
  ASSERT_EXIT_STATUS(
      Process({"/usr/bin/python3", (study / "indices").string()}, folder.path()).wait(patience), 0);
  const std::string indices = readText(folder / "results/studies/uncertainty/indices.csv");
  const auto of = [&](const std::string& parameter) {
    const std::size_t at = indices.find("," + parameter + ",");
    EXPECT_NE(at, std::string::npos) << indices;
    std::vector<std::string> cells;
    std::istringstream rest(indices.substr(at + 1, indices.find('\n', at) - at - 1));
    for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
    return cells;  // parameter, first and its interval, total and its interval, linear
  };
  EXPECT_NE(indices.find(",1.000,injury.syntheticReach,"), std::string::npos) << indices;
  EXPECT_NEAR(std::stod(of("injury.syntheticReach").at(7)), 4.0 / 13, 0.002);
  EXPECT_NEAR(std::stod(of("injury.stretchedStrain").at(7)), 9.0 / 13, 0.002);
  // By the design on 25 blocks no sharper than this
  EXPECT_NEAR(std::stod(of("injury.syntheticReach").at(4)), 4.0 / 13, 0.15);
  EXPECT_NEAR(std::stod(of("injury.stretchedStrain").at(4)), 9.0 / 13, 0.3);
  for (const int index : {1, 4, 7}) EXPECT_EQ(of("flow.meanVelocity").at(index), "0.000");
}

}  // namespace
}  // namespace restenosis
