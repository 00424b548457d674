#include <gtest/gtest.h>

#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/coupling/parts/LumenPart.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// Counts its solves.
struct CountingBackend : FlowBackend {
  explicit CountingBackend(int& s) : solves(s) {}
  std::string_view name() const override { return "counting"; }
  FlowSolution solve(const TriSurface&, const FlowConditions&, const std::filesystem::path&) override {
    ++solves;
    FlowSolution solution;
    solution.remarks = {"solved"};
    return solution;
  }
  int& solves;
};

/// A tube without tissue, and what the part names.
struct FlowPartTest : ::testing::Test {
  static Scene tube() {
    Scene scene;
    scene.flow.emplace().backend = "analytic";
    scene.vessel.stenosis = 0.3;
    return scene;
  }
  FlowPartTest() { LumenPart(quantities, extraction).run({}); }

  TemporaryFolder folder;
  Scene scene = tube();
  ResultsFolder results = ResultsFolder::fresh(folder / "results");
  Quantities quantities{emptyWall(scene.vessel)};
  std::optional<Stent> stent;
  PartTimer timer;
  LumenExtraction extraction{scene, quantities.wall, stent, timer};
  ArrestRules rules{BiologySettings{}};
  std::vector<std::string> remarks;
  int solves = 0;
  FlowPart part{quantities, scene,   results, rules,
                extraction, remarks, timer,   std::make_unique<CountingBackend>(solves)};
};

TEST_F(FlowPartTest, isDueFirstAndThenWhenTheLumenHasMoved) {
  EXPECT_TRUE(part.inputsChanged({}).yes);
  part.run({});
  EXPECT_EQ(solves, 1);
  EXPECT_EQ(quantities.changes(Quantity::wallTraction), 1u);
  EXPECT_EQ(part.inputsChanged({}).reason, "lumen moved no more than lumenTolerance");
  quantities.lumen.present =
      RadialMap::ofRound([](double) { return 0.7e-3; }, scene.vessel.length, scene.vessel.length / 100);
  quantities.flow.lumen =
      RadialMap::ofRound([](double) { return 0.8e-3; }, scene.vessel.length, scene.vessel.length / 100);
  EXPECT_TRUE(part.inputsChanged({}).yes);
}

TEST_F(FlowPartTest, waitsForTheNextLookAtTheLumenOnceItIsSolved) {
  const LumenPart lumen(quantities, extraction);
  const Instant between{.takesLumen = false};
  EXPECT_TRUE(lumen.inputsChanged(between).yes);
  EXPECT_TRUE(part.inputsChanged(between).yes);
  part.run(between);
  EXPECT_EQ(lumen.inputsChanged(between).reason, "lumenInterval is not over");
  quantities.flow.settings = {{"lbm.dx", "1e-05"}};
  EXPECT_EQ(part.inputsChanged(between).reason, "lumenInterval is not over");
  EXPECT_TRUE(lumen.inputsChanged({}).yes);
  EXPECT_TRUE(part.inputsChanged({}).yes);
}

TEST_F(FlowPartTest, isDueWhenItHasOtherSettings) {
  part.run({});
  quantities.flow.settings = {{"lbm.dx", "1e-05"}};
  EXPECT_TRUE(part.inputsChanged({}).yes);
  part.run({.step = 1, .time = 3600});
  EXPECT_TRUE(quantities.flow.mixed);
}

TEST_F(FlowPartTest, saysWhatTheBackendRemarks) {
  part.run({});
  EXPECT_EQ(remarks, std::vector<std::string>{"flow at day 0.000: solved"});
}

}  // namespace
}  // namespace restenosis
