#include <gtest/gtest.h>

#include "bridge/coupling/parts/WallShearPart.h"
#include "tests/support/Constants.h"

namespace restenosis {
namespace {

struct WallShearPartTest : ::testing::Test {
  static Wall oneCell() {
    Wall wall;
    wall.agents.append(AgentKind::smc, Vec3(1e-3, 0, 1e-3), support::r);
    return wall;
  }
  static Scene flowing() {
    Scene scene;
    scene.flow.emplace();
    return scene;
  }
  Scene scene = flowing();
  Quantities quantities{oneCell()};
  PartTimer timer;
  WallShearPart part{quantities, scene, timer};
};

TEST_F(WallShearPartTest, bringsTheStressOfTheFacesToTheCells) {
  EXPECT_EQ(part.inputsChanged({}).reason, "no flow solved yet");
  part.run({});
  EXPECT_EQ(quantities.changes(Quantity::wallShearStress), 0u);

  quantities.flow.last.emplace().wall = {
      {Vec3(0.98e-3, 0, 1e-3), 1e-10, Vec3(0, 0, 1.5), SurfaceRegion::wall}};
  EXPECT_TRUE(part.inputsChanged({}).yes);
  part.run({});
  EXPECT_DOUBLE_EQ(quantities.wall.agents.wss[0], 1.5);
  EXPECT_EQ(quantities.changes(Quantity::wallShearStress), 1u);
  part.noteInputs();
  EXPECT_EQ(part.inputsChanged({}).reason, "neither the flow nor the cells changed");
  quantities.countChange(Quantity::exposure);
  EXPECT_TRUE(part.inputsChanged({}).yes);
}

}  // namespace
}  // namespace restenosis
