#include <gtest/gtest.h>

#include "bridge/coupling/StressReaders.h"

namespace restenosis {
namespace {

struct StressReadersTest : ::testing::Test {
  StressReadersTest() {
    cell = agents.append(AgentKind::smc, Vec3::Zero(), 15e-6);
    agents.set(cell, AgentFlag::covered, true);
    agents.set(cell, AgentFlag::synthetic, true);
    agents.state[cell] = CycleState::g1;
    agents.wss[cell] = 0.5;
  }
  AgentStore agents;
  Index cell = 0;
};

TEST_F(StressReadersTest, aCoveredCellThatMayRestOrCycleReadsItsStress) {
  EXPECT_TRUE(readsStress(agents, cell));
  agents.state[cell] = CycleState::g0;
  EXPECT_TRUE(readsStress(agents, cell));
}

TEST_F(StressReadersTest, aCellPastG1DividesWhateverItsStress) {
  agents.state[cell] = CycleState::sg2m;
  EXPECT_FALSE(readsStress(agents, cell));
}

TEST_F(StressReadersTest, anyFlagThatDecidesAloneEndsTheReading) {
  agents.set(cell, AgentFlag::inhibited, true);
  EXPECT_FALSE(readsStress(agents, cell));
  agents.set(cell, AgentFlag::inhibited, false);
  agents.set(cell, AgentFlag::fixed, true);
  EXPECT_FALSE(readsStress(agents, cell));
  agents.set(cell, AgentFlag::fixed, false);
  agents.set(cell, AgentFlag::synthetic, false);
  EXPECT_FALSE(readsStress(agents, cell));
  agents.set(cell, AgentFlag::synthetic, true);
  agents.set(cell, AgentFlag::covered, false);
  EXPECT_FALSE(readsStress(agents, cell));
}

TEST_F(StressReadersTest, undecidedAreReadersBelowTheMargin) {
  EXPECT_EQ(undecidedCells(agents, 0.25, 2.5), std::vector<Index>{cell});
  EXPECT_TRUE(undecidedCells(agents, 0.25, 2.0).empty());  // 0.5 Pa is not below twice 0.25 Pa
  agents.state[cell] = CycleState::sg2m;
  EXPECT_TRUE(undecidedCells(agents, 0.25, 2.5).empty());
}

}  // namespace
}  // namespace restenosis
