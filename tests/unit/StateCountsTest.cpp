#include <gtest/gtest.h>

#include "tissue/biology/StateCounts.h"

namespace restenosis {
namespace {

TEST(StateCounts, CountsSmcByStateAndFlag) {
  AgentStore agents;
  for (int n = 0; n < 5; ++n) agents.append(AgentKind::smc, Vec3::Zero(), 15e-6);
  agents.append(AgentKind::iel, Vec3::Zero(), 15e-6);
  agents.flags = {synthetic | exposed | covered,
                  synthetic | exposed,
                  synthetic | inhibited,
                  exposed | covered,
                  daughter | covered,
                  synthetic | exposed};
  agents.state[1] = CycleState::g1;
  agents.state[2] = CycleState::sg2m;
  const StateCounts counts = countStates(agents);
  EXPECT_EQ(counts.smc, 5u);
  EXPECT_EQ(counts.g0, 3u);
  EXPECT_EQ(counts.g1, 1u);
  EXPECT_EQ(counts.sg2m, 1u);
  EXPECT_EQ(counts.synthetic, 3u);
  EXPECT_EQ(counts.inhibited, 1u);
  EXPECT_EQ(counts.exposed, 3u);
  EXPECT_EQ(counts.covered, 3u);
  EXPECT_EQ(counts.daughters, 1u);
  EXPECT_EQ(counts.exposedSynthetic, 2u);
  EXPECT_EQ(counts.coveredExposed, 1u);
  EXPECT_EQ(counts.coverage(), 0.5);
  EXPECT_EQ(StateCounts{}.coverage(), 0.0);
}

}  // namespace
}  // namespace restenosis
