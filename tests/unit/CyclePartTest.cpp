#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/coupling/parts/CyclePart.h"
#include "tests/support/Constants.h"

namespace restenosis {
namespace {

using namespace support;

struct CyclePartTest : ::testing::Test {
  static Wall oneCell() {
    Wall wall;
    wall.agents.append(AgentKind::smc, Vec3::Zero(), r);
    wall.agents.set(0, synthetic, true);
    wall.bonds.resize(1);
    return wall;
  }
  static BiologySettings settings() {
    BiologySettings given;
    given.cellCycle.emplace();
    given.endothelium.emplace();
    return given;
  }
  Quantities quantities{oneCell()};
  Biology biology{settings()};
  std::uint64_t divisions = 0;
  PartTimer timer;
  CyclePart part{quantities, biology, hour, divisions, timer};
};

TEST_F(CyclePartTest, growthIsAChangeOfCellStatesAndRestIsNone) {
  part.run({});
  EXPECT_GT(quantities.wall.agents.radius[0], r);
  EXPECT_EQ(quantities.changes(Quantity::cellStates), 1u);
  quantities.wall.agents.set(0, inhibited, true);
  part.run({.step = 1});
  EXPECT_EQ(quantities.changes(Quantity::cellStates), 1u);
}

TEST_F(CyclePartTest, countsDivisions) {
  for (std::uint32_t step = 0; divisions == 0 && step < 100; ++step) part.run({.step = step});
  EXPECT_EQ(divisions, 1u);
  EXPECT_EQ(quantities.wall.agents.size(), 2u);
}

TEST_F(CyclePartTest, needsStressWhereItMayChangeACell) {
  EXPECT_TRUE(std::ranges::count(part.reads(), Quantity::wallShearStress));
  EXPECT_EQ(part.needs(Quantity::wallShearStress, {}).reason, "no cell is covered by endothelium");
  quantities.wall.agents.set(0, covered, true);
  EXPECT_TRUE(part.needs(Quantity::wallShearStress, {}).yes);
  EXPECT_TRUE(part.needs(Quantity::exposure, {}).yes);
}

TEST_F(CyclePartTest, readsNoStressWhereNoRuleDoes) {
  Biology withoutEndothelium{BiologySettings{}};
  const CyclePart other(quantities, withoutEndothelium, hour, divisions, timer);
  EXPECT_FALSE(std::ranges::count(other.reads(), Quantity::wallShearStress));
}

}  // namespace
}  // namespace restenosis
