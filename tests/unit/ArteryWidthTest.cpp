#include <gtest/gtest.h>

#include "bridge/scene/ArteryWidth.h"

namespace restenosis {
namespace {

TEST(ArteryWidth, WidthsOfCoronaryArteriesArePassedOver) {
  for (const double diameter : {0.8e-3, 1.8e-3, 4.5e-3, 8e-3})
    EXPECT_EQ(remarkOnWidth({}, diameter), "") << diameter;
}

TEST(ArteryWidth, AMistakenUnitIsRemarkedOnWithTheRightOne) {
  Scene scene;
  scene.vessel.lumenSurface = "artery.stl";
  const auto remark = [&](const char* unit, double diameter) {
    scene.vessel.lumenSurfaceUnit = unit;
    return remarkOnWidth(scene, diameter);
  };
  EXPECT_EQ(remark("cm", 22e-3),
            "the inlet of artery.stl is 22 mm wide; coronary arteries are 0.8 to 8 mm wide. Is "
            "vessel.lumenSurfaceUnit, cm, right? In mm it would be 2.2 mm.");
  EXPECT_TRUE(remark("mm", 0.22e-3).ends_with("mm, right? In cm it would be 2.2 mm."))
      << remark("mm", 0.22e-3);
  EXPECT_TRUE(remark("um", 0.03e-3).ends_with("um, right?")) << remark("um", 0.03e-3);
  EXPECT_TRUE(remark("mm", 22e-3).ends_with("mm, right?")) << remark("mm", 22e-3);
}

TEST(ArteryWidth, ADiameterOfASceneIsRemarkedOn) {
  EXPECT_EQ(remarkOnWidth({}, 22e-3),
            "the lumen is 22 mm wide; coronary arteries are 0.8 to 8 mm wide: is the unit of "
            "vessel.lumenDiameter right?");
}

}  // namespace
}  // namespace restenosis
