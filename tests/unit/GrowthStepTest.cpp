#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "bridge/coupling/GrowthStep.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

struct GrowthStepTest : ::testing::Test {
  /// Names of the parts that a scene has, in their order.
  std::vector<std::string> parts(const Scene& scene) {
    RunState state(scene, results, progress);
    std::vector<std::string> names;
    for (const PartEntry& entry : growthStep())
      if (const auto part = entry.make({state})) names.emplace_back(part->name());
    return names;
  }
  TemporaryFolder folder;
  ResultsFolder results = ResultsFolder::fresh(folder / "results");
  std::ostringstream nowhere;
  Progress progress{nowhere, false, 1};
};

Scene wholeScene() {
  Scene scene;
  scene.mechanics.emplace();
  scene.relaxation.emplace();
  scene.cellCycle.emplace();
  scene.contactInhibition.emplace();
  scene.endothelium.emplace();
  scene.flow.emplace().backend = "analytic";
  scene.flow->crossCheck = "lbm";
  return scene;
}

TEST_F(GrowthStepTest, hasThePartsOfTheScenesSections) {
  EXPECT_EQ(parts(wholeScene()),
            (std::vector<std::string>{"relax", "exposure", "endothelium", "lumen", "flow", "crossCheck",
                                      "wallShear", "nitricOxide", "record", "cycle"}));
  Scene flowOnly;
  flowOnly.flow.emplace().backend = "analytic";
  EXPECT_EQ(parts(flowOnly), (std::vector<std::string>{"lumen", "flow", "record"}));
  Scene noFlow = wholeScene();
  noFlow.flow->backend = "none";
  EXPECT_EQ(parts(noFlow), (std::vector<std::string>{"relax", "exposure", "endothelium", "lumen",
                                                     "nitricOxide", "record", "cycle"}));
}

TEST_F(GrowthStepTest, withinAStepEachQuantityIsWrittenBeforeItIsRead) {
  const Scene scene = wholeScene();
  RunState state(scene, results, progress);
  std::vector<Quantity> written{Quantity::cellStates};  // by the step before
  for (const PartEntry& entry : growthStep()) {
    const auto part = entry.make({state});
    for (const Quantity quantity : part->reads())
      EXPECT_TRUE(std::ranges::count(written, quantity))
          << part->name() << " reads quantity " << static_cast<int>(quantity);
    written.insert(written.end(), part->writes().begin(), part->writes().end());
  }
}

TEST_F(GrowthStepTest, everyPartExplainsItselfForAnyScene) {
  const auto explained = [](const Scene& scene) {
    std::vector<std::string> names;
    for (const PartEntry& entry : growthStep())
      for (const PlannedPart& part : entry.explain(scene)) {
        EXPECT_FALSE(part.explanation.empty()) << part.name;
        names.push_back((part.runs ? "" : "no ") + part.name);
      }
    return names;
  };
  EXPECT_EQ(explained(Scene()),
            (std::vector<std::string>{"no relaxation", "no contact inhibition", "no endothelium",
                                      "lumen surface", "no flow", "no nitric oxide", "no cell cycle"}));
  Scene whole = wholeScene();
  whole.scene.duration = 30 * 86400.0;
  EXPECT_EQ(explained(whole),
            (std::vector<std::string>{"relaxation", "contact inhibition", "endothelium", "lumen surface",
                                      "flow (analytic)", "cross-check (lbm)", "nitric oxide", "cell cycle"}));
}

}  // namespace
}  // namespace restenosis
