#include <gtest/gtest.h>

#include "Plan.h"
#include "TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(Plan, CountsTheAgentsOfALoadedWall) {
  const TemporaryFolder folder;
  Scene scene;
  scene.mechanics.emplace();
  scene.vessel.agents = (folder.path() / "w.csv").string();
  writeText(scene.vessel.agents, "x,y,z,radius\n915,0,100,15\n945,0,100,15\n975,0,100,15\n");
  const std::string text = planText(scene);
  EXPECT_NE(text.find("loaded as it stands from " + scene.vessel.agents), std::string::npos) << text;
  EXPECT_NE(text.find("\n3 agents, 100 MB, "), std::string::npos) << text;
}

TEST(Plan, EstimatesTheAgentsOfAPackedWall) {
  Scene scene;
  EXPECT_EQ(planText(scene).find(" agents, "), std::string::npos);
  scene.mechanics.emplace();
  EXPECT_NE(planText(scene).find("\nabout 248"), std::string::npos) << planText(scene);
}

}  // namespace
}  // namespace restenosis
