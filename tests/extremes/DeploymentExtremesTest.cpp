// Deployments as no one should ask for them. All of them must succeed, but for a wall that cannot be packed.

#include <gtest/gtest.h>

#include "Deployment.h"
#include "SmallDeployment.h"
#include "StrutAgents.h"
#include "WallPacking.h"

namespace restenosis {
namespace {

using Setting = support::SmallDeployment;

/// Deploys, every step of it to rest, and expects a wall that is whole.
void deploy(const Setting& s) {
  Wall wall = packWall(s.vessel, s.mechanics, 1);
  Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics);
  ASSERT_NO_THROW(deployment.run(
      [](const Deployment&, const RelaxationReport& report) { EXPECT_TRUE(report.converged); }));
  EXPECT_TRUE(deployment.done());
  const DeploymentStatistics statistics = deployment.statistics();
  EXPECT_EQ(statistics.outside, 0u);
  for (Index i = 0; i < wall.agents.size(); ++i) {
    ASSERT_TRUE(wall.agents.position(i).allFinite());
    ASSERT_GE(wall.agents.z[i], 0);
    ASSERT_LE(wall.agents.z[i], s.vessel.length);
  }
}

TEST(DeploymentExtremes, AWallThatCannotBePackedNamesTheScenesSettings) {
  Setting s;
  s.vessel.wallThickness = 0.1e-3, s.vessel.lumenDiameter = 0.1e-3, s.vessel.length = 0.2e-3;
  s.mechanics.stepLimit = 1e-6;  // so that no agent gets anywhere
  try {
    packWall(s.vessel, s.mechanics, 1);
    FAIL();
  } catch (const RelaxationFailed& failure) {
    const std::string message = failure.what();
    for (const char* part : {"the packed wall did not come to rest: after 20000 iterations",
                             "half of mechanics.tolerance = 0.1", "mechanics.stepLimit (now 1e-06)"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(DeploymentExtremes, InOneStep) {
  for (const char* outer : {"free", "fixed"}) {
    SCOPED_TRACE(outer);
    Setting s;
    s.stent.deploymentSteps = 1;
    s.stent.outerLamina = outer;
    deploy(s);
  }
}

TEST(DeploymentExtremes, ThroughMostOfTheWall) {
  Setting s;
  s.stent.deploymentDepth = 0.9 * s.vessel.wallThickness;
  s.stent.deploymentSteps = 20;
  deploy(s);
}

TEST(DeploymentExtremes, ByNothing) {
  Setting s;
  s.stent.deploymentDepth = 0;
  s.stent.deploymentSteps = 1;
  deploy(s);
}

}  // namespace
}  // namespace restenosis
