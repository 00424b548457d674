#include <gtest/gtest.h>

#include <sstream>

#include "bridge/coupling/RunCheckpoint.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

struct RunCheckpointTest : ::testing::Test {
  TemporaryFolder folder;
  Scene scene;
  std::ostringstream said;
  Progress progress{said, false, 1};
  ResultsFolder results = ResultsFolder::fresh(folder / "results");
  RunState state{scene, results, progress};
  RunCheckpoint checkpoint{state};
  Checkpoint::StateWriter seven = [](StreamingArchive& a) {
    int value = 7;
    a(value);
  };
};

TEST_F(RunCheckpointTest, isDueBeforeTheFirstSolveAndElseNotAtOnce) {
  EXPECT_FALSE(checkpoint.due());
  EXPECT_TRUE(checkpoint.dueBeforeSolve());
  checkpoint.save(seven);
  EXPECT_TRUE(checkpoint.dueBeforeSolve());
}

TEST_F(RunCheckpointTest, keepsWhatItWasGiven) {
  EXPECT_FALSE(checkpoint.exists());
  checkpoint.save(seven);
  ASSERT_TRUE(checkpoint.exists());
  int value = 0;
  ReadingArchive read(checkpoint.load().bytes);
  read(value);
  EXPECT_EQ(value, 7);
}

TEST_F(RunCheckpointTest, remarksOnAStateThatAnotherProgramHasSaved) {
  checkpoint.save(seven);
  CheckpointOrigin origin = checkpoint.load().origin;
  checkpoint.adopt(origin, nullptr, 2, false);
  EXPECT_TRUE(state.reproducible);
  ASSERT_FALSE(origin.traits.empty());
  origin.traits.begin()->second = "another";
  checkpoint.adopt(origin, nullptr, 2, false);
  EXPECT_FALSE(state.reproducible);
  ASSERT_EQ(state.remarks.size(), 1u);
  EXPECT_TRUE(state.remarks[0].starts_with("resumed on day 2 by another program or machine"));
}

}  // namespace
}  // namespace restenosis
