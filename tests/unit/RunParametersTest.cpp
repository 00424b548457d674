#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/scene/RunParameters.h"

namespace restenosis {
namespace {

TEST(RunParameters, SayWhatTheWordsMean) {
  CouplingParameters coupling;
  EXPECT_EQ(coupling.scheduleMode(), ScheduleMode::onChange);
  EXPECT_TRUE(coupling.stressFollowsLumen());
  EXPECT_FALSE(coupling.movesMesh());
  coupling.schedule = "everyStep", coupling.stressUpdate = "none", coupling.remesh = "onDemand";
  EXPECT_EQ(coupling.scheduleMode(), ScheduleMode::everyStep);
  EXPECT_FALSE(coupling.stressFollowsLumen());
  EXPECT_TRUE(coupling.movesMesh());
  OutputParameters output;
  EXPECT_FALSE(output.keepsAllFlowCases());
  output.keepFlowCases = "all";
  EXPECT_TRUE(output.keepsAllFlowCases());
}

TEST(RunParameters, RefuseAWordThatIsNoneOfTheirs) {
  CouplingParameters coupling;
  coupling.schedule = "never";
  EXPECT_THROW(coupling.scheduleMode(), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
