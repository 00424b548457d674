#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {
namespace {

using namespace support;

class WallTest : public testing::Test {
 protected:
  WallTest() {
    VesselParameters vessel;
    vessel.length = vesselLength;
    vessel.cellRadius = r;
    wall = emptyWall(vessel);
  }
  Index add(AgentKind kind, double z) { return wall.agents.append(kind, {vesselRadius, 0, z}, r); }
  bool isFixed(Index i) const { return wall.agents.has(i, fixed); }

  Wall wall;
};

TEST_F(WallTest, EmptyWallHasTheVesselsGeometry) {
  VesselParameters vessel;
  vessel.lumenDiameter = 1e-3;
  vessel.wallThickness = 0.1e-3;
  const Wall empty = emptyWall(vessel);
  EXPECT_EQ(empty.agents.size(), 0u);
  EXPECT_EQ(empty.lumenRadius, 0.5e-3);
  EXPECT_EQ(empty.wallThickness, 0.1e-3);
  EXPECT_EQ(empty.length, vessel.length);
}

TEST_F(WallTest, EndsAreFixedWithinSoManyCellRadii) {
  const Index low = add(AgentKind::smc, 1.99 * r), high = add(AgentKind::iel, vesselLength - 1.99 * r),
              above = add(AgentKind::smc, 2.01 * r), below = add(AgentKind::smc, vesselLength - 2.01 * r);
  wall.agents.set(above, fixed, true);
  fixEnds(wall, 2);
  EXPECT_TRUE(isFixed(low) && isFixed(high));
  EXPECT_FALSE(isFixed(above) || isFixed(below));
  fixEnds(wall, 0);
  for (Index i = 0; i < wall.agents.size(); ++i) EXPECT_FALSE(isFixed(i));
}

TEST_F(WallTest, TheOuterLaminaIsFixedBesideTheEnds) {
  const Index end = add(AgentKind::smc, 0), cell = add(AgentKind::smc, vesselLength / 2),
              iel = add(AgentKind::iel, vesselLength / 2), eel = add(AgentKind::eel, vesselLength / 2);
  fixEnds(wall, 2);
  fixOuterLamina(wall);
  EXPECT_TRUE(isFixed(end) && isFixed(eel));
  EXPECT_FALSE(isFixed(cell) || isFixed(iel));
}

TEST_F(WallTest, OrderInSpaceKeepsAgentsAndBonds) {
  for (int n = 0; n < 200; ++n) add(AgentKind::smc, vesselLength * ((37 * n) % 200) / 200);
  wall.bonds.resize(wall.agents.size());
  for (Index i = 0; i + 1 < 200; i += 3) wall.bonds.connect(i, i + 1, r * (i + 1));
  const auto bondsById = [&] {
    std::set<std::tuple<AgentId, AgentId, double>> all;
    for (Index i = 0; i < wall.agents.size(); ++i)
      for (const Bond& bond : wall.bonds.of(i))
        all.emplace(wall.agents.id[i], wall.agents.id[bond.partner], bond.restLength);
    return all;
  };
  const AgentStore before = wall.agents;
  const auto bondsBefore = bondsById();
  const std::vector<Index> order = orderInSpace(wall);
  ASSERT_EQ(order.size(), before.size());
  for (Index k = 0; k < before.size(); ++k) {
    EXPECT_EQ(wall.agents.id[k], before.id[order[k]]);
    EXPECT_EQ(wall.agents.z[k], before.z[order[k]]);
  }
  EXPECT_EQ(bondsById(), bondsBefore);
  EXPECT_EQ(bondsBefore.size(), 2 * 67u);
  double path = 0, pathBefore = 0;
  for (Index k = 0; k + 1 < before.size(); ++k) {
    path += std::abs(wall.agents.z[k + 1] - wall.agents.z[k]);
    pathBefore += std::abs(before.z[k + 1] - before.z[k]);
  }
  EXPECT_LT(path, pathBefore / 10);
}

}  // namespace
}  // namespace restenosis
