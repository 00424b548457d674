#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/GrowthStep.h"
#include "bridge/coupling/Schedule.h"
#include "bridge/coupling/WallPreparation.h"
#include "bridge/coupling/parts/RecordPart.h"
#include "bridge/scene/SceneBiology.h"
#include "tests/support/TemporaryFolder.h"
#include "tissue/biology/ContractileArrest.h"
#include "tissue/biology/InhibitionArrest.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {
namespace {

/// A worked example: a new rule of biology that reads wall shear stress. This is all there is to write, but
/// for its row in the table.
class HighStressArrest : public ArrestRule {
 public:
  static std::unique_ptr<const ArrestRule> make(const BiologySettings&) {
    return std::make_unique<HighStressArrest>();
  }
  bool arrests(const AgentStore& agents, Index cell) const override { return agents.wss[cell] > 3; }
  bool readsWss() const override { return true; }
};

constexpr std::array<MakeArrestRule, 3> withNewRule{ContractileArrest::make, InhibitionArrest::make,
                                                    HighStressArrest::make};

/// Growth without endothelium: nothing but a new rule can read the flow.
Scene sceneOfGrowth() {
  Scene scene;
  scene.scene.duration = 4 * secondsPerDay;
  scene.scene.step = 2 * 3600;
  scene.vessel.length = 0.24e-3;
  scene.vessel.lumenDiameter = 0.4e-3;
  scene.vessel.wallThickness = 0.12e-3;
  scene.vessel.cellRadius = 18e-6;
  scene.mechanics.emplace();
  scene.relaxation.emplace();
  scene.injury.emplace();
  scene.injury->synthetic = "all";
  scene.injury->removeIel = true;
  scene.cellCycle.emplace();
  scene.contactInhibition.emplace();
  scene.flow.emplace().backend = "analytic";
  return scene;
}

/// A run whose cells rest by the rules of a table, up to the first step of growth.
struct FirstStep {
  explicit FirstStep(std::span<const MakeArrestRule> rules) {
    state.biology = Biology(biologySettings(scene), rules);
    WallPreparation preparation(state, options);
    preparation.makeWall();
    preparation.injureAndConfine();
    for (const PartEntry& entry : growthStep())
      if (auto part = entry.make({state})) schedule.add(std::move(part));
    schedule.find<RecordPart>()->begin();
    schedule.advance(instantOf(scene, 0));
  }
  TemporaryFolder folder;
  Scene scene = sceneOfGrowth();
  std::ostringstream nowhere;
  Progress progress{nowhere, false, 1};
  ResultsFolder results = ResultsFolder::fresh(folder / "results");
  RunOptions options;
  RunState state{scene, results, progress};
  Schedule schedule{ScheduleMode::onChange};
};

TEST(NewRule, HasTheFlowSolvedAndItsStressBroughtToTheCells) {
  const FirstStep run(withNewRule);
  EXPECT_EQ(run.state.quantities.flow.solves, 1u);
  EXPECT_GT(std::ranges::max(run.state.quantities.wall.agents.wss), 0);
}

TEST(NewRule, WithoutItTheFlowIsNotSolved) {
  const FirstStep run(arrestRuleTable());
  EXPECT_EQ(run.state.quantities.flow.solves, 0u);
  EXPECT_EQ(run.schedule.counts().at("flow").skipped.at("no rule reads wall shear stress"), 1u);
}

TEST(NewRule, IsPlannedFor) {
  const Scene scene = sceneOfGrowth();
  const BiologySettings settings = biologySettings(scene);
  EXPECT_EQ(noFlowBecause(scene, ArrestRules(settings, withNewRule)), "");
  EXPECT_NE(noFlowBecause(scene, ArrestRules(settings)), "");
}

}  // namespace
}  // namespace restenosis
