// Deployments as no one should ask for them: they succeed, or they are stopped with the setting to change.

#include <gtest/gtest.h>

#include "tests/support/SmallDeployment.h"
#include "tests/support/WholeProgram.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

using Setting = support::SmallDeployment;

/// Deploys, every step of it to rest, and expects a wall that is whole and either outside the struts or
/// refused.
void deploy(const Setting& s) {
  Wall wall = packWall(s.vessel, s.mechanics, s.relaxation, 1);
  Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
  ASSERT_NO_THROW(deployment.run(
      [](const Deployment&, const RelaxationReport& report) { EXPECT_TRUE(report.converged); }));
  EXPECT_TRUE(deployment.done());
  const DeploymentStatistics statistics = deployment.statistics();
  EXPECT_EQ(statistics.outside, 0u);
  if (statistics.escaped > 0) {
    EXPECT_TRUE(strutsWentThrough(statistics)) << statistics.escaped;
  }
  for (Index i = 0; i < wall.agents.size(); ++i) {
    ASSERT_TRUE(wall.agents.position(i).allFinite());
    ASSERT_GE(wall.agents.z[i], 0);
    ASSERT_LE(wall.agents.z[i], s.vessel.length);
  }
}

TEST(DeploymentExtremes, AWallThatCannotBePackedNamesTheScenesSettings) {
  Setting s;
  s.vessel.wallThickness = 0.1e-3, s.vessel.lumenDiameter = 0.1e-3, s.vessel.length = 0.2e-3;
  s.relaxation.stepLimit = 1e-6;  // so that no agent gets anywhere
  try {
    packWall(s.vessel, s.mechanics, s.relaxation, 1);
    FAIL();
  } catch (const RelaxationFailed& failure) {
    const std::string message = failure.what();
    for (const char* part : {"the packed wall did not come to rest: after 20000 iterations",
                             "relaxation.tolerance = 0.003", "relaxation.stepLimit (now 1e-06)"})
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

class DeploymentOfTheProgram : public WholeProgram {};

/// The struts land beyond much of the wall, which cannot know that it was to be in front of them.
TEST_F(DeploymentOfTheProgram, InOneStepThroughTheWallIsStoppedBeforeAnythingGrows) {
  const std::string tiny = scene("tiny", with(tinyScene, "40 um", "80 um"));
  const ProcessEnd end = run({"run", tiny, "-o", "out", "--set", "stent.deploymentSteps=1"});
  EXPECT_EXIT_STATUS(end, 1);
  for (const char* part : {"the struts went through the wall", "raise stent.deploymentSteps (now 1)"})
    EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
  EXPECT_FALSE(exists("out/timeSeries.csv"));
  const auto json = summary("out");
  EXPECT_EQ(json["status"], "failed");
  EXPECT_GT(json["deployment"]["freeAgentsLumenwardOfStruts"], 0);
  ASSERT_EQ(json["remarks"].size(), 1u);
  EXPECT_NE(std::string(json["remarks"][0]).find("stent.deploymentSteps"), std::string::npos);

  const ProcessEnd finer = run({"run", tiny, "-o", "finer", "--flow", "none", "--set", "scene.duration=2 h"});
  EXPECT_EXIT_STATUS(finer, 0);
  EXPECT_EQ(summary("finer")["deployment"]["agentsLumenwardOfStruts"], 0);
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
