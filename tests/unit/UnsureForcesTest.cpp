#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/equilibrium/UnsureForces.h"

namespace restenosis {
namespace {

using support::r;

/// Agents in a row that touch, in mixed precision; the first and the last are bonded.
struct Row {
  AgentStore agents;
  BondTable bonds;
  NeighbourRange range{.factor = 1, .daughterFactor = 1.5, .skin = 8 * r};  // lists more than act
  NeighbourList neighbours;
  AgentSpheres spheres{agents, bonds, FixedScale(r)};
  UnsureForces unsure{agents, bonds, neighbours, spheres, range};

  static constexpr Index count = 8;
  Row() {
    for (Index i = 0; i < count; ++i) agents.append(AgentKind::smc, Vec3(1.9 * r * i, 0, 0), r);
    bonds.resize(count);
    bonds.connect(0, count - 1, r);
    neighbours.build(agents, range);
    spheres.choosePrecision();
    spheres.packAll();
    unsure.start(count);
    unsure.know();
  }
  std::vector<Index> marked() const {
    return unsure.those([](Index) { return true; });
  }
  using Agents = std::vector<Index>;
};

TEST(UnsureForces, AreAllUntilTheyAreKnown) {
  Row row;
  EXPECT_TRUE(row.marked().empty());
  row.unsure.start(Row::count);
  EXPECT_EQ(row.marked().size(), Row::count);
}

TEST(UnsureForces, AreThoseOnWhomOneThatMovedActsOrActed) {
  Row row;
  row.unsure.startMoving(std::array<Index, 1>{2});
  row.agents.setPosition(2, row.agents.position(5) + Vec3(0, 1.9 * r, 0));
  row.unsure.markAroundMoving();
  EXPECT_EQ(row.marked(), (Row::Agents{1, 2, 3, 5})) << "listed are all";
}

TEST(UnsureForces, AreThoseOnPartnersOfBondsHoweverFar) {
  Row row;
  row.unsure.markAround(std::array<Index, 1>{0});
  EXPECT_EQ(row.marked(), (Row::Agents{0, 1, 7}));
}

TEST(UnsureForces, ReachFartherAroundADaughter) {
  Row row;
  row.agents.setPosition(4, row.agents.position(4) + Vec3(0, 1.5 * r, 0));
  row.spheres.remember(std::array<Index, 1>{4});
  row.unsure.markAround(std::array<Index, 1>{4});
  EXPECT_EQ(row.marked(), (Row::Agents{4})) << "2.4 radii from its neighbours";
  row.agents.set(4, AgentFlag::daughter, true);
  row.unsure.markAround(std::array<Index, 1>{4});
  EXPECT_EQ(row.marked(), (Row::Agents{3, 4, 5}));
}

TEST(UnsureForces, AreNotThoseAroundAnAgentThatHasStopped) {
  Row row;
  row.unsure.startMoving(std::array<Index, 2>{2, 2});
  EXPECT_EQ(row.unsure.moving().size(), 1u);
  row.unsure.stopMoving();
  row.unsure.markAroundMoving();
  EXPECT_TRUE(row.marked().empty());
}

}  // namespace
}  // namespace restenosis
