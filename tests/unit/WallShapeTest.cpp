#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {
namespace {

using namespace support;

TEST(WallShape, OfACylinder) {
  VesselParameters vessel;
  vessel.length = 2e-3;
  vessel.lumenDiameter = 1.8e-3;
  vessel.wallThickness = 0.2e-3;
  vessel.cellRadius = 15e-6;
  const WallShape shape = cylindricalShape(vessel);
  const Vec3 place(1, 2, 3);
  EXPECT_DOUBLE_EQ(shape.iel.at(place), 0.915e-3);
  EXPECT_DOUBLE_EQ(shape.inner.at(place), 0.930e-3);
  EXPECT_DOUBLE_EQ(shape.outer.at(place), 1.070e-3);
  EXPECT_DOUBLE_EQ(shape.eel.at(place), 1.085e-3);
  EXPECT_DOUBLE_EQ(shape.ielArea, 2 * pi * 0.915e-3 * 2e-3);
  EXPECT_DOUBLE_EQ(shape.eelArea, 2 * pi * 1.085e-3 * 2e-3);
  EXPECT_NEAR(shape.volume, pi * (1.1 * 1.1 - 0.9 * 0.9) * 2e-9, 1e-21);
}

}  // namespace
}  // namespace restenosis
