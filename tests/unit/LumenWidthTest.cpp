#include <gtest/gtest.h>

#include "LumenWidth.h"
#include "TubeSurface.h"

namespace restenosis {
namespace {

TEST(LumenWidth, IsTheDiameterOfATubeWhereItIsNarrowest) {
  const NarrowestPlace straight = narrowestPlace(support::tube(0.9e-3, 1.2e-3), 0.05e-3);
  EXPECT_NEAR(straight.width / 1.8e-3, 1, 1e-3);
  const TriSurface throat =
      support::revolve({{0.9e-3, 0}, {0.9e-3, 1e-3}, {0.3e-3, 1.5e-3}, {0.9e-3, 2e-3}, {0.9e-3, 3e-3}});
  const NarrowestPlace narrowest = narrowestPlace(throat, 0.01e-3);
  EXPECT_NEAR(narrowest.width, 0.6e-3, 0.013e-3);  // planes lie up to half a spacing beside the throat
  ASSERT_TRUE(narrowest.fromInlet.has_value());
  EXPECT_NEAR(*narrowest.fromInlet, 1.5e-3, 0.01e-3);
}

TEST(LumenWidth, OfASlitIsTwiceItsGap) {
  TriSurface slit = support::tube(0.9e-3, 1.2e-3);
  for (Vec3& v : slit.vertices) v.y() *= 0.01;
  // 4 pi a b over the perimeter of a flat ellipse, 4 a: pi b
  EXPECT_NEAR(narrowestPlace(slit, 0.05e-3).width / (std::numbers::pi * 0.009e-3), 1, 2e-3);
}

TEST(LumenWidth, OfALumenThatDoesNotLieAlongZIsThatOfItsEnds) {
  TriSurface lying = support::tube(0.9e-3, 1.2e-3);
  for (Vec3& v : lying.vertices) v = Vec3(v.z(), v.x(), v.y());
  const NarrowestPlace narrowest = narrowestPlace(lying, 0.05e-3);
  EXPECT_NEAR(narrowest.width / 1.8e-3, 1, 1e-3);
  EXPECT_FALSE(narrowest.fromInlet.has_value());
}

TEST(LumenWidth, IsRemarkedOnWhereFewPiecesLieAcross) {
  const TriSurface lumen = support::tube(0.1e-3, 1.2e-3);
  const auto remark = [&](double size) {
    return narrownessRemark(lumen, {size, "cells at the wall", 4, "a smaller one resolves it"});
  };
  EXPECT_EQ(remark(49e-6), "");
  const std::string text = remark(80e-6);
  EXPECT_NE(text.find("the lumen is 200 um wide, 2.5 cells at the wall of 80 um: with less than 4"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("a smaller one resolves it"), std::string::npos) << text;
}

}  // namespace
}  // namespace restenosis
