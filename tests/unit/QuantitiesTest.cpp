#include <gtest/gtest.h>

#include "bridge/coupling/Quantities.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

Wall wallOfOneCell() {
  Wall wall;
  wall.agents.append(AgentKind::smc, Vec3::Zero(), 15e-6);
  return wall;
}

TEST(Quantities, AreReachedByTheirNames) {
  Quantities quantities(wallOfOneCell());
  EXPECT_EQ(&*Read<Quantity::lumen>(quantities), &quantities.lumen);
  EXPECT_EQ(&*Read<Quantity::wallTraction>(quantities), &quantities.flow);
  EXPECT_EQ(&*Read<Quantity::agentPositions>(quantities), &quantities.wall);
  EXPECT_EQ(&*Read<Quantity::wallShearStress>(quantities), &quantities.wall.agents);
}

TEST(Quantities, EachChangeIsCountedWhereItIsMade) {
  Quantities quantities(wallOfOneCell());
  Write<Quantity::exposure> exposure(quantities);
  EXPECT_EQ(quantities.changes(Quantity::exposure), 0u);
  exposure.change([](AgentStore& agents) { agents.set(0, exposed, true); });
  EXPECT_TRUE(exposure->has(0, exposed));
  EXPECT_EQ(quantities.changes(Quantity::exposure), 1u);
  EXPECT_EQ(quantities.changes(Quantity::coverage), 0u) << "others are not, though the same data hold them";
}

TEST(Quantities, AChangeMaySayThatNothingChanged) {
  Quantities quantities(wallOfOneCell());
  Write<Quantity::cellStates> cells(quantities);
  cells.change([](Wall&) { return false; });
  EXPECT_EQ(quantities.changes(Quantity::cellStates), 0u);
  cells.change([](Wall&) { return true; });
  EXPECT_EQ(quantities.changes(Quantity::cellStates), 1u);
}

TEST(Quantities, ACheckpointKeepsThemAndTheirChanges) {
  Quantities quantities(wallOfOneCell());
  quantities.countChange(Quantity::lumen);
  quantities.flow.solves = 3;
  WritingArchive writing;
  writing(quantities);
  Quantities resumed{Wall()};
  resumed.countChange(Quantity::coverage);
  ReadingArchive reading(writing.buffer());
  reading(resumed);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_EQ(resumed.wall.agents.size(), 1u);
  EXPECT_EQ(resumed.flow.solves, 3u);
  EXPECT_EQ(resumed.changes(Quantity::lumen), 1u);
  EXPECT_EQ(resumed.changes(Quantity::coverage), 0u) << "nothing of its own is left";
}

TEST(Quantities, AFlowBeforeTheFirstHasAnySettings) {
  FlowState flow;
  EXPECT_TRUE(flow.hasSettings({{"lbm.dx", "2e-05"}}));
  flow.solves = 1;
  EXPECT_FALSE(flow.hasSettings({{"lbm.dx", "2e-05"}}));
  flow.settings = {{"lbm.dx", "2e-05"}};
  EXPECT_TRUE(flow.hasSettings({{"lbm.dx", "2e-05"}}));
}

}  // namespace
}  // namespace restenosis
