#include <gtest/gtest.h>

#include <array>

#include "tests/support/Constants.h"
#include "tissue/biology/ArrestRules.h"
#include "tissue/biology/CellCycle.h"
#include "tissue/biology/NitricOxide.h"

namespace restenosis {
namespace {

using namespace support;

BiologySettings withEndothelium() {
  BiologySettings settings;
  settings.endothelium.emplace();
  return settings;
}

struct ArrestRulesTest : ::testing::Test {
  ArrestRulesTest() {
    cell = agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.set(cell, covered, true);
    agents.set(cell, synthetic, true);
    agents.state[cell] = CycleState::g1;
    agents.wss[cell] = 0.5;
  }
  AgentStore agents;
  Index cell = 0;
  ArrestRules rules{withEndothelium()};
};

TEST_F(ArrestRulesTest, anyRuleArrests) {
  EXPECT_FALSE(rules.arrest(agents, cell));
  agents.set(cell, inhibited, true);
  EXPECT_TRUE(rules.arrest(agents, cell));
  agents.set(cell, inhibited, false);
  agents.set(cell, synthetic, false);
  EXPECT_TRUE(rules.arrest(agents, cell));
  agents.set(cell, synthetic, true);
  agents.nitricOxide[cell] = 0.001;
  EXPECT_TRUE(rules.arrest(agents, cell));
  EXPECT_FALSE(ArrestRules(BiologySettings{}).arrest(agents, cell)) << "no endothelium, no nitric oxide";
}

TEST_F(ArrestRulesTest, wssMayChangeACoveredCellThatMayRestOrCycle) {
  EXPECT_TRUE(rules.wssMayChange(agents, cell));
  EXPECT_EQ(rules.wssChangesNothingBecause(agents), "");
  agents.state[cell] = CycleState::g0;
  EXPECT_TRUE(rules.wssMayChange(agents, cell));
  agents.nitricOxide[cell] = 1;
  EXPECT_TRUE(rules.wssMayChange(agents, cell)) << "less stress would set it free";
}

TEST_F(ArrestRulesTest, wssChangesNoCellPastG1) {
  agents.state[cell] = CycleState::sg2m;
  EXPECT_FALSE(rules.wssMayChange(agents, cell));
}

TEST_F(ArrestRulesTest, wssChangesNoCellThatAnotherRuleArrests) {
  const auto decidedBy = [&](AgentFlag flag, bool value) {
    const bool before = agents.has(cell, flag);
    agents.set(cell, flag, value);
    const bool may = rules.wssMayChange(agents, cell);
    EXPECT_EQ(rules.undecidedCells(agents, 2.5).empty(), !may);
    agents.set(cell, flag, before);
    return !may;
  };
  EXPECT_TRUE(decidedBy(inhibited, true));
  EXPECT_TRUE(decidedBy(fixed, true));
  EXPECT_TRUE(decidedBy(synthetic, false));
  EXPECT_TRUE(decidedBy(covered, false));
  EXPECT_FALSE(decidedBy(exposed, true));
}

TEST_F(ArrestRulesTest, saysWhyWssChangesNothing) {
  agents.set(cell, inhibited, true);
  EXPECT_EQ(rules.wssChangesNothingBecause(agents),
            "every covered cell rests or divides whatever its wall shear stress");
  agents.set(cell, covered, false);
  EXPECT_EQ(rules.wssChangesNothingBecause(agents), "no cell is covered by endothelium");
  const ArrestRules without{BiologySettings{}};
  EXPECT_FALSE(without.readWss());
  EXPECT_EQ(without.wssChangesNothingBecause(agents), "no rule reads wall shear stress");
}

TEST_F(ArrestRulesTest, undecidedAreCellsBelowTheMarginOfTheDecidingStress) {
  EXPECT_EQ(rules.undecidedCells(agents, 2.5), std::vector<Index>{cell});
  EXPECT_TRUE(rules.undecidedCells(agents, 1.8).empty());  // 0.5 Pa is not below 1.8 times 0.273 Pa
}

TEST_F(ArrestRulesTest, saysFromWhenWssIsRead) {
  EXPECT_EQ(rules.readNoWssUntil(4 * 86400.0), "");
  EXPECT_EQ(rules.readNoWssUntil(2 * 86400.0), "endothelium returns after the end of the run (day 3)");
}

/// Every agent that differs in a flag, the phase or the kind.
AgentStore agentsOfAllSorts() {
  AgentStore agents;
  for (int flags = 0; flags < 128; ++flags)
    for (const auto state : {CycleState::g0, CycleState::g1, CycleState::sg2m}) {
      const Index i = agents.append(AgentKind::smc, Vec3::Zero(), r);
      agents.flags[i] = static_cast<std::uint8_t>(flags);
      agents.state[i] = state;
    }
  return agents;
}

TEST(ArrestRuleTable, whereAnAnswerTurnsWithWssTheRuleSaysThatItReadsIt) {
  const BiologySettings settings = withEndothelium();
  const NitricOxide nitricOxide(*settings.endothelium);
  AgentStore agents = agentsOfAllSorts();
  for (const MakeArrestRule make : arrestRuleTable()) {
    const auto rule = make(settings);
    const auto answers = [&](double wss) {
      std::ranges::fill(agents.wss, wss);
      nitricOxide.apply(agents);
      std::vector<bool> answers;
      for (Index i = 0; i < agents.size(); ++i) answers.push_back(rule->arrests(agents, i));
      return answers;
    };
    const auto unloaded = answers(0), decided = answers(rule->decidingWss());
    for (const double wss : {1e-3, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0}) {
      const auto loaded = answers(wss);
      for (Index i = 0; i < agents.size(); ++i) {
        EXPECT_TRUE(loaded[i] == unloaded[i] || (rule->readsWss() && rule->readsWssOf(agents, i)));
        EXPECT_TRUE(wss < rule->decidingWss() || loaded[i] == decided[i]) << wss;
      }
    }
  }
}

}  // namespace
}  // namespace restenosis
