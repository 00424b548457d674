#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/biology/NitricOxideArrest.h"

namespace restenosis {
namespace {

using namespace support;

struct NitricOxideArrestTest : ::testing::Test {
  NitricOxideArrestTest() { agents.append(AgentKind::smc, Vec3::Zero(), r); }
  AgentStore agents;
  NitricOxideArrest rule{EndotheliumParameters(), 3 * 86400.0};
};

TEST_F(NitricOxideArrestTest, arrestsAtAndAboveTheThreshold) {
  agents.nitricOxide[0] = 0.000999;
  EXPECT_FALSE(rule.arrests(agents, 0));
  agents.nitricOxide[0] = 0.001;
  EXPECT_TRUE(rule.arrests(agents, 0));
}

TEST_F(NitricOxideArrestTest, readsTheStressOfCoveredCells) {
  EXPECT_TRUE(rule.readsWss());
  EXPECT_FALSE(rule.readsWssOf(agents, 0));
  agents.set(0, covered, true);
  EXPECT_TRUE(rule.readsWssOf(agents, 0));
  EXPECT_NEAR(rule.decidingWss(), 0.273, 0.0005);
}

TEST_F(NitricOxideArrestTest, isUndecidedBelowTheMarginOfTheDecidingStress) {
  agents.set(0, covered, true);
  agents.wss[0] = 0.5;
  EXPECT_TRUE(rule.undecided(agents, 0, 2));
  EXPECT_FALSE(rule.undecided(agents, 0, 1.8));
}

TEST_F(NitricOxideArrestTest, needsMoreStressOfEndotheliumThatIsNotMature) {
  EndotheliumParameters parameters;
  parameters.maturationTime = 86400;
  const NitricOxideArrest maturing(parameters, 0);
  agents.maturity.model(1);
  agents.wss[0] = 0.8;
  for (const auto& [maturity, undecided] :
       {std::pair(0.0F, true), {0.25F, true}, {0.5F, false}, {1.0F, false}}) {
    agents.maturity.set(0, maturity);
    EXPECT_EQ(maturing.undecided(agents, 0, 1), undecided) << maturity;  // 0.273 Pa over its maturity decide
  }
  EXPECT_EQ(maturing.decidingWss(), never);
}

TEST_F(NitricOxideArrestTest, readsTheStressOfOthersWhereNitricOxideReachesThem) {
  EndotheliumParameters parameters;
  parameters.nitricOxideReach = 100e-6;
  const NitricOxideArrest reaching(parameters, 0);
  EXPECT_TRUE(reaching.readsWssOf(agents, 0));
  EXPECT_EQ(reaching.decidingWss(), never);
  agents.nitricOxide[0] = 0.0015;
  EXPECT_TRUE(reaching.undecided(agents, 0, 2));
  EXPECT_FALSE(reaching.undecided(agents, 0, 1.4));
}

TEST_F(NitricOxideArrestTest, saysWhenItReadsThem) {
  EXPECT_EQ(rule.whenWssIsRead(),
            "from the first covered cell (not before day 3), when a covered cell could still cycle");
  EXPECT_EQ(rule.readsNoWssUntil(86400), "endothelium returns after the end of the run (day 3)");
  EXPECT_EQ(rule.readsNoWssUntil(4 * 86400.0), "");
  EXPECT_EQ(NitricOxideArrest(EndotheliumParameters(), never).readsNoWssUntil(86400),
            "the endothelium never returns");
}

TEST_F(NitricOxideArrestTest, isNoRuleWithoutEndothelium) {
  EXPECT_EQ(NitricOxideArrest::make(BiologySettings()), nullptr);
}

}  // namespace
}  // namespace restenosis
