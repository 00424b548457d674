#include <gtest/gtest.h>

#include <sstream>

#include "bridge/coupling/FormerFlowCase.h"
#include "bridge/output/Checkpoint.h"
#include "bridge/scene/SceneFingerprint.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// Starts from the file `mesh` of a former case.
struct StartingBackend : FlowBackend {
  std::string_view name() const override { return "starting"; }
  FlowSolution solve(const TriSurface&, const FlowConditions&, const std::filesystem::path&) override {
    return {};
  }
  bool needsFormerCase() const override { return true; }
  std::vector<std::filesystem::path> filesToStartFrom(const std::filesystem::path&) const override {
    return {"mesh"};
  }
};

/// A state read from a checkpoint, one solve after the start.
struct FormerFlowCaseTest : ::testing::Test {
  FormerFlowCaseTest() {
    folderOfCase = results.flowCase(0);
    std::filesystem::create_directories(folderOfCase);
    writeText(folderOfCase / "mesh", "cells");
    FlowState& flow = state.quantities.flow;
    flow.solves = 1;
    flow.settings = flowSettings(scene);
    flow.startFiles = part.startFiles(folderOfCase);
  }
  static Scene flowing() {
    Scene scene;
    scene.flow.emplace().backend = "analytic";
    return scene;
  }
  TemporaryFolder folder;
  Scene scene = flowing();
  std::ostringstream said;
  Progress progress{said, false, 1};
  ResultsFolder results = ResultsFolder::fresh(folder / "results");
  RunState state{scene, results, progress};
  FlowPart part{state.quantities, scene,         results,     state.biology.rules(),
                state.extraction, state.remarks, state.timer, std::make_unique<StartingBackend>()};
  FormerFlowCase former{state};
  std::filesystem::path folderOfCase;
};

TEST_F(FormerFlowCaseTest, isGoneOnFromWhereItIsAsItWas) {
  EXPECT_NO_THROW(former.requireAfterResume(&part, "state.bin", 1, false));
  EXPECT_EQ(state.quantities.flow.caseInCheckpoint, folderOfCase);
  EXPECT_NO_THROW(former.requireAfterResume(nullptr, "state.bin", 1, false)) << "no flow, no case";
}

TEST_F(FormerFlowCaseTest, isRefusedWhereItIsChangedOrGone) {
  const auto reason = [&] {
    try {
      former.requireAfterResume(&part, "state.bin", 1, false);
    } catch (const CheckpointRefused& refused) {
      return refused.reason;
    }
    return CheckpointRefused::Reason::missing;
  };
  writeText(folderOfCase / "mesh", "others");
  EXPECT_EQ(reason(), CheckpointRefused::Reason::caseChanged);
  std::filesystem::remove_all(folderOfCase);
  EXPECT_EQ(reason(), CheckpointRefused::Reason::caseMissing);
}

TEST_F(FormerFlowCaseTest, mayBeGoneOnFromAtRestWithARemark) {
  std::filesystem::remove_all(folderOfCase);
  former.requireAfterResume(&part, "state.bin", 1, true);
  EXPECT_TRUE(state.quantities.flow.fromRest);
  EXPECT_FALSE(state.reproducible);
  EXPECT_EQ(state.remarks.size(), 1u);
}

}  // namespace
}  // namespace restenosis
