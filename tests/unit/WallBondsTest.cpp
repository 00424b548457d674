#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/vessel/WallBonds.h"

namespace restenosis {
namespace {

using namespace support;

Wall wallOf(const std::vector<std::pair<AgentKind, Vec3>>& places) {
  Wall wall;
  wall.cellRadius = r;
  for (const auto& [kind, place] : places) wall.agents.append(kind, place, r);
  return wall;
}

TEST(WallBonds, JoinsWallAgentsWithinRangeAtTheirDistance) {
  Wall wall = wallOf({{AgentKind::smc, {0, 0, 0}},
                      {AgentKind::iel, {2.1 * r, 0, 0}},
                      {AgentKind::eel, {-2.3 * r, 0, 0}},
                      {AgentKind::strut, {0, 2 * r, 0}}});
  EXPECT_EQ(bondWall(wall, 1.1), 1u);
  ASSERT_TRUE(wall.bonds.bonded(0, 1));
  EXPECT_NEAR(wall.bonds.of(0)[0].restLength, 2.1 * r, 1e-11);
}

TEST(WallBonds, RestLengthOfAnOverlappingPairIsItsDistance) {
  Wall wall = wallOf({{AgentKind::smc, {0, 0, 0}}, {AgentKind::smc, {1.6 * r, 0, 0}}});
  bondWall(wall, 1.1);
  EXPECT_NEAR(wall.bonds.of(0)[0].restLength, 1.6 * r, 1e-11);
}

TEST(WallBonds, KeepsTheNearestTwelve) {
  // Twenty cells around one that is large, so that all are in its range and none in another's. Which is how
  // near has nothing to do with their order.
  constexpr Index around = 20;
  const auto rank = [](Index n) { return 7 * n % around; };
  Wall wall;
  wall.cellRadius = r;
  wall.agents.append(AgentKind::smc, Vec3::Zero(), 4 * r);
  for (Index n = 0; n < around; ++n) {
    const double height = 1 - (2.0 * n + 1) / around, angle = pi * (3 - std::sqrt(5.0)) * n;
    const double across = std::sqrt(1 - height * height);
    wall.agents.append(
        AgentKind::smc,
        (5 + 0.02 * rank(n)) * r * Vec3(across * std::cos(angle), across * std::sin(angle), height), r);
  }
  EXPECT_EQ(bondWall(wall, 1.1), BondTable::maxBonds);
  EXPECT_EQ(wall.bonds.of(0).size(), 12u);
  for (Index n = 0; n < around; ++n)
    EXPECT_EQ(wall.bonds.bonded(0, n + 1), rank(n) < 12) << "neighbour " << rank(n);
}

TEST(WallBonds, DoNotDependOnTheOrderOfAgents) {
  Wall wall;
  wall.cellRadius = r;
  for (Index n = 0; n < 300; ++n) {
    RandomStream random(3, n, 0, RandomPurpose::packing);
    wall.agents.append(AgentKind::smc, 8 * r * Vec3(random.uniform(), random.uniform(), random.uniform()), r);
  }
  Wall reversed = wall;
  std::vector<Index> order(wall.agents.size());
  for (Index n = 0; n < order.size(); ++n) order[n] = static_cast<Index>(order.size()) - 1 - n;
  reversed.agents.reorder(order);
  EXPECT_EQ(bondWall(wall, 1.1), bondWall(reversed, 1.1));
  for (Index a = 0; a < wall.agents.size(); ++a) {
    for (const Bond& bond : wall.bonds.of(a))
      EXPECT_TRUE(reversed.bonds.bonded(order[a], order[bond.partner]));
  }
}

TEST(WallBonds, RangeZeroMakesNone) {
  Wall wall = wallOf({{AgentKind::smc, {0, 0, 0}}, {AgentKind::smc, {1e-9, 0, 0}}});
  EXPECT_EQ(bondWall(wall, 0), 0u);
  EXPECT_EQ(wall.bonds.size(), 2u);
}

}  // namespace
}  // namespace restenosis
