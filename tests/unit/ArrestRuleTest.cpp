#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/biology/ContractileArrest.h"
#include "tissue/biology/InhibitionArrest.h"

namespace restenosis {
namespace {

using namespace support;

struct ArrestRuleTest : testing::Test {
  ArrestRuleTest() { agents.append(AgentKind::smc, Vec3::Zero(), r); }
  AgentStore agents;
};

TEST_F(ArrestRuleTest, ContractileAndInhibitedCellsRest) {
  const auto contractile = ContractileArrest::make(BiologySettings());
  const auto inhibition = InhibitionArrest::make(BiologySettings());
  ASSERT_TRUE(contractile && inhibition);
  EXPECT_TRUE(contractile->arrests(agents, 0));
  EXPECT_FALSE(inhibition->arrests(agents, 0));
  agents.set(0, synthetic, true);
  agents.set(0, inhibited, true);
  EXPECT_FALSE(contractile->arrests(agents, 0));
  EXPECT_TRUE(inhibition->arrests(agents, 0));
}

TEST_F(ArrestRuleTest, ByDefaultARuleReadsNoWallShearStress) {
  const ContractileArrest rule;
  EXPECT_FALSE(rule.readsWss());
  EXPECT_FALSE(rule.readsWssOf(agents, 0));
  EXPECT_EQ(rule.readsNoWssUntil(0), "");
}

/// Arrests no cell, but reads the stress of all.
struct ReadingRule : ArrestRule {
  bool arrests(const AgentStore&, Index) const override { return false; }
  bool readsWss() const override { return true; }
};

TEST_F(ArrestRuleTest, ByDefaultARuleThatReadsItReadsThatOfEveryCellAtAnyValue) {
  const ReadingRule rule;
  EXPECT_TRUE(rule.readsWssOf(agents, 0));
  EXPECT_EQ(rule.decidingWss(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace restenosis
