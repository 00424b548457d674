#include <gtest/gtest.h>

#include "bridge/flow/LumenWidth.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/SweptTube.h"

namespace restenosis {
namespace {

using namespace support;

constexpr WallPieces cells{45e-6, "cells at the wall", 4.0, "a smaller cellSize resolves it"};

TriSurface throat(double radius) {
  return revolve({{0.9e-3, 0.0}, {radius, 0.4e-3}, {radius, 0.6e-3}, {0.9e-3, 1e-3}});
}

TEST(LumenWidth, IsTheDiameterOfTheNarrowestPlace) {
  const NarrowestPlace place = narrowestPlace(throat(0.1e-3), 45e-6);
  EXPECT_NEAR(place.width / 0.2e-3, 1.0, 1e-3);
  ASSERT_TRUE(place.fromInlet);
  EXPECT_NEAR(*place.fromInlet, 0.5e-3, 0.11e-3);
}

TEST(LumenWidth, OfAnAnnulusIsTwiceTheGap) {
  EXPECT_NEAR(narrowestPlace(annularTube(0.9e-3, 0.8e-3, 1e-3), 45e-6).width / 0.2e-3, 1.0, 2e-3);
}

TEST(LumenWidth, OfABentLumenIsThatOfItsEnds) {
  const NarrowestPlace place = narrowestPlace(bentTube(0.3e-3, 1e-3, 2e-3, 1e-3), 45e-6);
  EXPECT_NEAR(place.width / 0.6e-3, 1.0, 1e-3);
  EXPECT_FALSE(place.fromInlet);
}

TEST(LumenWidth, IsRemarkedOnWhereItIsFewPiecesAcross) {
  EXPECT_EQ(narrownessRemark(throat(0.1e-3), cells), "");
  const std::string said = narrownessRemark(throat(0.05e-3), cells);
  EXPECT_NE(said.find("the lumen is 100 um wide, 2.2 cells at the wall of 45 um"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with("a smaller cellSize resolves it")) << said;
}

}  // namespace
}  // namespace restenosis
