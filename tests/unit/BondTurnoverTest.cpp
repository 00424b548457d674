#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/forces/BondTurnover.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore row(std::initializer_list<double> places, AgentKind kind = AgentKind::smc) {
  AgentStore agents;
  for (const double x : places) agents.append(kind, {x * r, 0, 0}, r);
  return agents;
}

BondTable bondsOf(const AgentStore& agents) {
  BondTable bonds;
  bonds.resize(agents.size());
  return bonds;
}

TEST(BondTurnover, BreaksWhatIsStrainedPastTheLimitOnly) {
  const AgentStore agents = row({0, 2.2, 4.6});
  BondTable bonds = bondsOf(agents);
  bonds.connect(0, 1, 2 * r), bonds.connect(1, 2, 2 * r);
  EXPECT_EQ(breakStrainedBonds(agents, bonds, 0), 0U) << "no limit";
  EXPECT_EQ(breakStrainedBonds(agents, bonds, 0.15), 1U);
  EXPECT_TRUE(bonds.bonded(0, 1));
  EXPECT_FALSE(bonds.bonded(1, 2));
  EXPECT_EQ(breakStrainedBonds(agents, bonds, 0.15), 0U);
}

TEST(BondTurnover, LeavesTheInnerLaminaToInjury) {
  AgentStore agents = row({0, 3}, AgentKind::iel);
  BondTable bonds = bondsOf(agents);
  bonds.connect(0, 1, 2 * r);
  EXPECT_EQ(breakStrainedBonds(agents, bonds, 0.1), 0U);
  agents.kind[1] = AgentKind::smc;
  EXPECT_EQ(breakStrainedBonds(agents, bonds, 0.1), 1U);
}

TEST(BondTurnover, BondsDaughtersWithoutBondsToWhomTheyTouchWithoutLoad) {
  AgentStore agents = row({0, 1.9, 4.05, 6.4, 8.3});
  agents.kind[4] = AgentKind::strut;
  for (const Index i : {Index{1}, Index{3}}) agents.set(i, daughter, true);
  BondTable bonds = bondsOf(agents);
  EXPECT_EQ(bondDaughters(agents, bonds, 0), 0U);
  EXPECT_EQ(bondDaughters(agents, bonds, 1.1), 2U);
  ASSERT_EQ(bonds.of(1).size(), 2U);
  EXPECT_FLOAT_EQ(bonds.of(1)[0].restLength, 1.9 * r);
  EXPECT_FLOAT_EQ(bonds.of(1)[1].restLength, 2.15 * r);
  EXPECT_TRUE(bonds.of(3).empty()) << "a strut is no partner, and the others are too far";
  EXPECT_FALSE(bonds.bonded(0, 2)) << "others keep the bonds they have";
  EXPECT_EQ(bondDaughters(agents, bonds, 1.1), 0U);
}

TEST(BondTurnover, DoesNotDependOnTheOrderOfAgents) {
  AgentStore agents;
  for (int k = 0; k < 40; ++k) {
    const Index i = agents.append(AgentKind::smc, Vec3(k % 4, (k / 4) % 4, k / 16) * 1.2 * r, r);
    agents.set(i, daughter, k % 3 == 0);
  }
  std::vector<Index> reversed(agents.size());
  for (Index i = 0; i < agents.size(); ++i) reversed[i] = agents.size() - 1 - i;
  AgentStore other = agents;
  other.reorder(reversed);
  BondTable bonds = bondsOf(agents), others = bondsOf(other);
  EXPECT_EQ(bondDaughters(agents, bonds, 1.1), bondDaughters(other, others, 1.1));
  for (Index i = 0; i < agents.size(); ++i)
    for (Index j = 0; j < i; ++j) EXPECT_EQ(bonds.bonded(i, j), others.bonded(reversed[i], reversed[j]));
}

}  // namespace
}  // namespace restenosis
