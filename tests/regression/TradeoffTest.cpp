#include "bridge/surface/StlFile.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class Tradeoff : public WholeProgram {
 protected:
  std::vector<std::string> lines(const std::string& file) const {
    std::vector<std::string> all;
    std::istringstream stream(readText(folder.path() / file));
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
  }
  /// The n-th field of a line.
  static std::string field(const std::string& line, int n) {
    std::istringstream fields(line);
    std::string text;
    for (int k = 0; k <= n; ++k) std::getline(fields, text, ',');
    return text;
  }
};

const std::string smallVessel = R"([scene]
duration = "1 d"
fidelity = "draft"
[vessel]
length = "0.3 mm"
lumenDiameter = "0.6 mm"
wallThickness = "0.1 mm"
[mechanics]
[injury]
removeIel = true
synthetic = "all"
[cellCycle]
[contactInhibition]
)";

TEST_F(Tradeoff, RunsWhatIsAskedForOnceAndGoesOn) {
  const std::string small = scene("small", smallVessel);
  const std::vector<std::string> command = {"tradeoff", small,           "-o",
                                            "out",      "--vary",        "relaxation.tolerance=0.0005,0.001",
                                            "--vary",   "scene.seed=1,2"};
  ASSERT_EXIT_STATUS(run(command), 0);
  const auto first = lines("out/tradeoff.csv");
  ASSERT_EQ(first.size(), 5u);
  EXPECT_EQ(first[0], "setting,value,seconds,error,meaning");
  EXPECT_TRUE(first[1].starts_with("relaxation.tolerance,0.0005,")) << first[1];
  EXPECT_TRUE(first[1].ends_with(",0,neointima thickness on day 1 against relaxation.tolerance = 0.0005"))
      << first[1];
  EXPECT_TRUE(first[4].starts_with("scene.seed,2,")) << first[4];
  EXPECT_TRUE(std::filesystem::exists(folder / "out/runs/scene.seed=2/summary.json"));
  // The scene as it is was run already, with its own tolerance
  EXPECT_FALSE(std::filesystem::exists(folder / "out/runs/scene.seed=1"));

  std::filesystem::remove_all(folder / "out/runs/relaxation.tolerance=0.0005");
  const auto kept = std::filesystem::last_write_time(folder / "out/runs/scene.seed=2/summary.json");
  ASSERT_EXIT_STATUS(run(command), 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/runs/relaxation.tolerance=0.0005/summary.json"));
  EXPECT_EQ(std::filesystem::last_write_time(folder / "out/runs/scene.seed=2/summary.json"), kept);

  // A file that the scene names was another then, say
  const auto summaryFile = folder / "out/runs/scene.seed=2/summary.json";
  const std::string fingerprint = summary("out/runs/scene.seed=2")["sceneFingerprint"];
  writeText(summaryFile, with(readText(summaryFile), fingerprint, "another"));
  ASSERT_EXIT_STATUS(run(command), 0);
  EXPECT_EQ(summary("out/runs/scene.seed=2")["sceneFingerprint"], fingerprint);
}

TEST_F(Tradeoff, RunsAnewWhatIsDamaged) {
  const std::vector<std::string> command = {
      "tradeoff", scene("small", smallVessel), "-o", "out", "--vary", "scene.seed=1,2"};
  ASSERT_EXIT_STATUS(run(command), 0);
  const std::filesystem::path second = folder / "out/runs/scene.seed=2";
  const std::string digest = summary("out/runs/scene.seed=2")["stateDigest"];
  for (const char* text : {"", "[]", "null", R"({"final": 3})"}) {
    writeText(second / "summary.json", text);
    std::filesystem::resize_file(second / "checkpoint/state.bin", 1000);
    const ProcessEnd end = run(command);
    EXPECT_EXIT_STATUS(end, 0);
    EXPECT_NE(end.err.find("run again from the start"), std::string::npos) << end.err;
    EXPECT_EQ(summary("out/runs/scene.seed=2")["stateDigest"], digest);
  }
}

TEST_F(Tradeoff, LeavesOutARunThatFails) {
  const std::string small = scene("small", smallVessel);
  const ProcessEnd end =
      run({"tradeoff", small, "-o", "out", "--vary", "relaxation.maximumIterations=20000,1"});
  EXPECT_EXIT_STATUS(end, 0);
  EXPECT_NE(end.err.find("relaxation.maximumIterations = 1 is left out"), std::string::npos) << end.err;
  EXPECT_EQ(lines("out/tradeoff.csv").size(), 2u);
}

TEST_F(Tradeoff, MeasuresTheFlowAgainstWhatIsKnown) {
  const std::string tube = scene("tube", R"([scene]
duration = "1 h"
[vessel]
length = "0.6 mm"
lumenDiameter = "0.6 mm"
[flow]
[foam]
cellSize = "60 um"
wallLevel = 1
[lbm]
collision = "trt"
[output]
pictures = false
)");
  ASSERT_EXIT_STATUS(run({"tradeoff", tube, "-o", "out"}), 0);
  const auto rows = lines("out/tradeoff.csv");
  ASSERT_EQ(rows.size(), 6u) << "with these cells, standard is what reference is; three lattices";
  EXPECT_TRUE(rows[1].starts_with("scene.fidelity (foam),reference,")) << rows[1];
  EXPECT_TRUE(rows[2].starts_with("scene.fidelity (foam),draft,")) << rows[2];
  EXPECT_TRUE(rows[5].starts_with("scene.fidelity (lbm),draft,")) << rows[5];
  for (std::size_t n = 1; n < rows.size(); ++n) {
    EXPECT_TRUE(rows[n].ends_with("wall shear stress (L2) against Poiseuille's law")) << rows[n];
    EXPECT_GT(std::stod(field(rows[n], 2)), 0) << rows[n];
    EXPECT_LT(std::stod(field(rows[n], 3)), 0.1) << rows[n];
  }
  EXPECT_NE(field(rows[3], 3), field(rows[5], 3)) << "[lbm] without dx leaves the spacing to the fidelity";

  ASSERT_EXIT_STATUS(
      run({"tradeoff", tube, "-o", "spacing", "--set", "lbm.dx=40 um", "--set", "lbm.tolerance=1e-3"}), 0);
  const auto given = lines("spacing/tradeoff.csv");
  ASSERT_EQ(given.size(), 4u) << "one spacing and tolerance is one lattice";
  EXPECT_TRUE(given[3].starts_with("scene.fidelity (lbm),reference,")) << given[3];
}

TEST_F(Tradeoff, RefusesWhatIsNoSweepBeforeAnythingIsWritten) {
  const std::string small = scene("small", smallVessel);
  for (const char* vary : {"scene.seed", "scene.seed=1", "scene.sed=1,2", "relaxation.tolerance=0.01,-1"}) {
    const ProcessEnd end = run({"tradeoff", small, "-o", "out", "--vary", vary});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_EQ(end.err.rfind("--vary " + std::string(vary).substr(0, 7), 0), 0u) << end.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

}  // namespace
}  // namespace restenosis
