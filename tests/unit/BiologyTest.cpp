#include <gtest/gtest.h>

#include <limits>

#include "tests/support/Constants.h"
#include "tissue/biology/Biology.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore oneCellUnderFlow() {
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3(0, 0, 1e-3), r);
  agents.set(0, synthetic, true);
  return agents;
}

BiologySettings everything() {
  BiologySettings settings;
  settings.cellCycle.emplace();
  settings.contactInhibition.emplace();
  settings.endothelium.emplace();
  return settings;
}

TEST(Biology, ArrestsALoneCellOnceEndotheliumReturnsUnderFlow) {
  Biology biology(everything());
  AgentStore agents = oneCellUnderFlow();
  BondTable bonds;
  bonds.resize(1);
  agents.wss[0] = 1.6;
  biology.updateInhibition(agents);
  EXPECT_TRUE(agents.has(0, exposed));

  EXPECT_EQ(biology.updateEndothelium(agents, 0).covered, 0u);
  biology.updateNitricOxide(agents);
  EXPECT_EQ(biology.advanceCycle(agents, bonds).enteredG1, 1u);

  EXPECT_EQ(biology.updateEndothelium(agents, 23 * 86400.0).covered, 1u);
  biology.updateNitricOxide(agents);
  EXPECT_GT(agents.nitricOxide[0], 0.001);
  EXPECT_EQ(biology.advanceCycle(agents, bonds).arrested, 1u);
}

TEST(Biology, DividesInAStepLongerThanTheCycle) {
  BiologySettings settings = everything();
  settings.step = 100 * 3600.0;
  Biology biology(settings);
  AgentStore agents = oneCellUnderFlow();
  BondTable bonds;
  bonds.resize(1);
  biology.updateInhibition(agents);
  EXPECT_EQ(biology.advanceCycle(agents, bonds).divisions, 1u);
  EXPECT_EQ(agents.size(), 2u);
  EXPECT_EQ(bonds.size(), 2u);
}

TEST(Biology, DoesNotModelAbsentSections) {
  Biology biology(BiologySettings{});
  AgentStore agents = oneCellUnderFlow();
  BondTable bonds;
  bonds.resize(1);
  agents.wss[0] = 1.6;
  biology.updateInhibition(agents);
  EXPECT_FALSE(agents.has(0, inhibited));
  EXPECT_TRUE(agents.has(0, exposed));
  EXPECT_EQ(biology.updateEndothelium(agents, 1e9).covered, 0u);
  biology.updateNitricOxide(agents);
  EXPECT_EQ(agents.nitricOxide[0], 0.0);
  EXPECT_EQ(biology.advanceCycle(agents, bonds).enteredG1, 0u);
  EXPECT_FALSE(biology.hasCycle());
  EXPECT_FALSE(biology.hasEndothelium());
  EXPECT_EQ(biology.endotheliumOnset(), never);
  EXPECT_EQ(biology.arrestingWss(), never);
}

TEST(Biology, SaysWhenFlowCouldMatter) {
  EXPECT_EQ(Biology(everything()).endotheliumOnset(), 3 * 86400.0);
  EXPECT_NEAR(Biology(everything()).arrestingWss(), 0.273, 0.0005);
}

}  // namespace
}  // namespace restenosis
