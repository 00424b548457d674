#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/biology/Division.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore grownCells(Index n) {
  AgentStore agents;
  for (Index i = 0; i < n; ++i) {
    agents.append(AgentKind::smc, Vec3(1e-4 * i, 2e-4, 3e-4), r);
    agents.radius[i] = r * std::cbrt(2.0);
    agents.state[i] = CycleState::sg2m;
    agents.g1Duration[i] = 1000;
    agents.clock[i] = 123;
    agents.wss[i] = 0.5;
    agents.set(i, synthetic, true);
    agents.set(i, covered, true);
  }
  return agents;
}

TEST(Division, MakesTwoCellsOfTheOriginalVolume) {
  AgentStore agents = grownCells(1);
  agents.set(0, injuredIel, true);
  agents.set(0, inhibited, true);
  BondTable bonds;
  bonds.resize(1);
  Division(1, 0.4).divide(agents, bonds, std::array<Index, 1>{0});
  ASSERT_EQ(agents.size(), 2u);
  EXPECT_EQ(bonds.size(), 2u);
  for (Index i = 0; i < 2; ++i) {
    EXPECT_EQ(agents.radius[i], r);
    EXPECT_EQ(agents.birthRadius[i], r);
    EXPECT_EQ(agents.state[i], CycleState::g0);
    EXPECT_EQ(agents.clock[i], 123);
    EXPECT_EQ(agents.g1Duration[i], 0);
    EXPECT_EQ(agents.generation[i], 1u);
    EXPECT_EQ(agents.wss[i], 0.5);
    EXPECT_TRUE(agents.has(i, synthetic));
    EXPECT_TRUE(agents.has(i, covered));
    EXPECT_NEAR((agents.position(i) - Vec3(0, 2e-4, 3e-4)).norm(), 0.4 * r, 1e-15);
  }
  EXPECT_LT((agents.position(0) + agents.position(1) - 2 * Vec3(0, 2e-4, 3e-4)).norm(), 1e-15);
  EXPECT_FALSE(agents.has(0, daughter));
  EXPECT_TRUE(agents.has(1, daughter));
  EXPECT_TRUE(agents.has(0, injuredIel));
  EXPECT_FALSE(agents.has(1, injuredIel));
}

TEST(Division, LeavesTheBondsWithTheMother) {
  AgentStore agents = grownCells(2);
  BondTable bonds;
  bonds.resize(2);
  bonds.connect(0, 1, 1e-4);
  Division(1, 0.4).divide(agents, bonds, std::array<Index, 1>{0});
  ASSERT_EQ(bonds.size(), 3u);
  EXPECT_TRUE(bonds.bonded(0, 1));
  EXPECT_FLOAT_EQ(bonds.of(0)[0].restLength, 1e-4f);
  EXPECT_TRUE(bonds.of(2).empty());
}

TEST(Division, AppendsDaughtersInTheOrderOfTheMothersNames) {
  AgentStore agents = grownCells(3);
  BondTable bonds;
  bonds.resize(3);
  agents.reorder(std::vector<Index>{2, 0, 1});
  Division(1, 0.4).divide(agents, bonds, std::array<Index, 2>{1, 0});
  EXPECT_EQ(agents.id[3], daughterId(0, 1));
  EXPECT_NEAR((agents.position(3) - agents.position(1)).norm(), 0.8 * r, 1e-15);
  EXPECT_EQ(agents.id[4], daughterId(2, 1));
  EXPECT_NEAR((agents.position(4) - agents.position(0)).norm(), 0.8 * r, 1e-15);
}

TEST(Division, NamesADaughterWhateverElseIsBorn) {
  AgentStore alone = grownCells(2), among = grownCells(2);
  BondTable bonds, others;
  bonds.resize(2), others.resize(2);
  const Division division(1, 0.4);
  division.divide(alone, bonds, std::array<Index, 1>{1});
  division.divide(among, others, std::array<Index, 1>{0});
  division.divide(among, others, std::array<Index, 1>{1});
  EXPECT_EQ(alone.id[2], among.id[3]);
  EXPECT_EQ(alone.position(2), among.position(3));
}

TEST(Division, GivesEveryCellOfAPedigreeItsOwnName) {
  std::vector<AgentId> cells;
  for (AgentId founder = 0; founder < 100; ++founder) cells.push_back(founder);
  for (std::uint32_t generation = 1; generation <= 10; ++generation) {
    const std::size_t mothers = cells.size();
    for (std::size_t i = 0; i < mothers; ++i) cells.push_back(daughterId(cells[i], generation));
  }
  EXPECT_EQ(std::set<AgentId>(cells.begin(), cells.end()).size(), 102400u);
  EXPECT_LT(std::ranges::max(cells), AgentId{1} << 63) << "fits a signed 64-bit integer";
  EXPECT_GE(cells[100], AgentId{1} << 62) << "out of reach of counted names";
}

}  // namespace
}  // namespace restenosis
