#include <gtest/gtest.h>

#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

DeploymentStatistics escaped(Index inPath, Index free, Index held, bool passed = true) {
  DeploymentStatistics wall;
  wall.freeInPath = inPath;
  wall.escaped = free + held;
  wall.escapedFree = free;
  wall.passedFree = passed ? free : 0;
  return wall;
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(EscapedAgents, AreRemarkedWithWhatKeepsThemBehindTheStruts) {
  EXPECT_EQ(remarkOnEscaped(escaped(100, 0, 0), 1), "");
  const std::string free = remarkOnEscaped(escaped(100, 3, 0), 7);
  EXPECT_TRUE(contains(free, "after deployment 3 of the agents in the path of struts are"));
  EXPECT_TRUE(contains(free, "3 free, of which struts have passed 3, raise stent.deploymentSteps (now 7)"));
  EXPECT_FALSE(contains(free, "vessel.fixedEnds"));
  const std::string held = remarkOnEscaped(escaped(100, 0, 1), 7);
  EXPECT_TRUE(contains(held, "1 of the agents in the path of struts is")) << held;
  EXPECT_TRUE(contains(held, "lower vessel.fixedEnds"));
  EXPECT_FALSE(contains(held, "deploymentSteps"));
}

TEST(EscapedAgents, OnlyPressedAgainstStrutsAreNoMatterOfSteps) {
  const DeploymentStatistics soft = escaped(100, 30, 0, false);
  EXPECT_NO_THROW(requireWallOutsideStruts(soft, 1));
  const std::string text = remarkOnEscaped(soft, 7);
  EXPECT_TRUE(contains(text, "30 free, none by more than half a cell radius")) << text;
  EXPECT_FALSE(contains(text, "deploymentSteps")) << text;
}

TEST(EscapedAgents, OfMoreThanATenthStopTheRun) {
  EXPECT_NO_THROW(requireWallOutsideStruts(escaped(0, 0, 0), 1));
  EXPECT_NO_THROW(requireWallOutsideStruts(escaped(100, 10, 0), 1));
  EXPECT_NO_THROW(requireWallOutsideStruts(escaped(100, 0, 90), 1)) << "these cannot move";
  try {
    requireWallOutsideStruts(escaped(100, 11, 5), 3);
    FAIL();
  } catch (const DeploymentFailed& failure) {
    const std::string message = failure.what();
    EXPECT_TRUE(contains(message, "11 of the 100 agents")) << message;
    EXPECT_TRUE(contains(message, "stent.deploymentSteps (now 3)")) << message;
  }
}

TEST(EscapedAgents, AreCountedFreeOrFixed) {
  VesselParameters vessel;
  vessel.length = 0.6e-3;
  const Stent stent = stentOfDesign(StentParameters(), vessel);
  const Vec3 strut = stent.segments.front().a;
  const double outerFace = radiusOf(strut) + stent.segments.front().thickness / 2;
  Wall wall = emptyWall(vessel);
  const auto append = [&](double radius, bool held) {
    const Index i = wall.agents.size();
    wall.agents.append(AgentKind::smc, atRadius(strut, radius), vessel.cellRadius);
    wall.agents.set(i, fixed, held);
  };
  const double margin = vessel.cellRadius / 2;
  for (const double over : {10e-6, 40e-6, -margin + 1e-6, -margin - 1e-6}) append(outerFace + over, false);
  append(outerFace - 20e-6, true);
  append(outerFace + 20e-6, true);
  wall.agents.append(AgentKind::smc, Vec3(outerFace, 0, 0), vessel.cellRadius);  // beside the strut
  wall.bonds.resize(wall.agents.size());
  const DeploymentStatistics result = measureDeployment(wall, stent);
  EXPECT_EQ(result.freeInPath, 4u);
  EXPECT_EQ(result.escaped, 3u);
  EXPECT_EQ(result.escapedFree, 2u);
  EXPECT_EQ(result.passedFree, 1u);
}

}  // namespace
}  // namespace restenosis
