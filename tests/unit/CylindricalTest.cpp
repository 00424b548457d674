#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

TEST(Cylindrical, OfAPointInEachQuadrant) {
  for (const auto& [x, y, angle] : {std::tuple(3.0, 4.0, std::atan(4.0 / 3)),
                                    {-3.0, 4.0, pi - std::atan(4.0 / 3)},
                                    {-3.0, -4.0, std::atan(4.0 / 3) - pi},
                                    {3.0, -4.0, -std::atan(4.0 / 3)}}) {
    const Cylindrical c = toCylindrical({x, y, -7});
    EXPECT_DOUBLE_EQ(c.radius, 5);
    EXPECT_DOUBLE_EQ(c.angle, angle);
    EXPECT_EQ(c.z, -7);
    EXPECT_LT((toCartesian(c) - Vec3(x, y, -7)).norm(), 1e-14);
  }
  EXPECT_EQ(toCylindrical({-1, 0, 0}).angle, pi);
}

TEST(Cylindrical, RadialIsAUnitVectorNormalToTheAxis) {
  const Vec3 out = radialAt({3, -4, 7});
  EXPECT_LT((out - Vec3(0.6, -0.8, 0)).norm(), 1e-15);
  EXPECT_EQ(radialAt({0, 0, 7}), Vec3(1, 0, 0));
}

TEST(Cylindrical, AtRadiusKeepsAngleAndZ) {
  EXPECT_LT((atRadius({3, -4, 7}, 10) - Vec3(6, -8, 7)).norm(), 1e-14);
  EXPECT_EQ(atRadius({0, 0, 7}, 2), Vec3(2, 0, 7));
}

}  // namespace
}  // namespace restenosis
