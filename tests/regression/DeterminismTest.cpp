#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using Determinism = WholeProgram;

TEST_F(Determinism, TheDigestDependsOnTheSeedAndNotOnTheThreads) {
  const std::string tiny = scene("tiny", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "one", "--threads", "1"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "two", "--threads", "2"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "other", "--set", "scene.seed=2"}), 0);
  EXPECT_EQ(summary("one")["threads"], 1);
  EXPECT_EQ(summary("two")["threads"], 2);
  EXPECT_EQ(digest("one"), digest("two"));
  EXPECT_EQ(readText(folder / "one/timeSeries.csv"), readText(folder / "two/timeSeries.csv"));
  EXPECT_NE(digest("one"), digest("other"));
}

TEST_F(Determinism, GrowthBeneathTheEndotheliumDoesNotDependOnTheThreads) {
  const std::string growing = scene("growing", growingScene());
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "one", "--threads", "1"}), 0);
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "two", "--threads", "2"}), 0);
  EXPECT_EQ(digest("one"), digest("two"));
  const auto json = summary("one");
  EXPECT_GT(json["final"]["divisions"], 5);
  EXPECT_GT(json["final"]["inhibited"], 100);
  EXPECT_GT(json["final"]["nitricOxideMean_nmolPerMm3"], 0);
}

/// The reference solves the flow in every step (T6). What is saved must not show in the result.
TEST_F(Determinism, SolvingTheFlowOnChangeGivesTheGrowthOfEveryStep) {
  const std::string tiny = scene("tiny", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "onChange"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "everyStep", "--set", "coupling.schedule=everyStep"}), 0);
  const auto change = summary("onChange"), every = summary("everyStep");
  EXPECT_EQ(every["flow"]["solvesDone"], 49);  // 48 steps and the final state
  EXPECT_LT(change["flow"]["solvesDone"], 15);
  const double reference = every["final"]["neointimaThickness_um"];
  EXPECT_NEAR(change["final"]["neointimaThickness_um"], reference, 0.02 * reference);
}

}  // namespace
}  // namespace restenosis
