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
