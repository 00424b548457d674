#include <gtest/gtest.h>

#include <limits>

#include "FixedScale.h"

namespace restenosis {
namespace {

constexpr double length = 15e-6;

TEST(FixedScale, UnitIsThePowerOfTwoBelowALengthOverFourMillion) {
  const FixedScale scale(length);
  EXPECT_LE(scale.unit(), length * 0x1p-22);
  EXPECT_GT(2 * scale.unit(), length * 0x1p-22);
  EXPECT_EQ(scale.reach(), scale.unit() * 0x1p31);
}

TEST(FixedScale, TellsDistancesAlikeWhereverInSpace) {
  const FixedScale scale(length);
  const Vec3 apart = scale.unit() * Vec3(1 << 20, -3, 1 << 10);
  const auto distanceAt = [&](const Vec3& place) {
    return squaredDistance(scale.of(place), scale.of(place + apart));
  };
  const float near = distanceAt(Vec3::Zero());
  EXPECT_EQ(near, 0x1p40F + 9 + 0x1p20F);
  // Whole numbers of units, many periods away.
  EXPECT_EQ(distanceAt(Vec3::Constant(scale.unit() * 0x1p36)), near);
  EXPECT_EQ(distanceAt(Vec3::Constant(-scale.unit() * 0x1.8p34)), near);
}

TEST(FixedScale, PlacesFartherApartThanItsReachSeemNearer) {
  const FixedScale scale(length);
  const FixedPlace origin = scale.of(Vec3::Zero());
  for (const double far : {1.5, 2.0, 3.1, 1e9}) {
    const double distance = far * scale.reach();
    EXPECT_LE(squaredDistance(origin, scale.of(Vec3(distance, 0, 0))), 0x1p62F) << far;
  }
}

TEST(FixedScale, TakesNumbersOfAnySize) {
  const FixedScale scale(length);
  constexpr double most = std::numeric_limits<double>::max();
  const FixedPlace far = scale.of(Vec3(most, -most, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(far.z, 0u);
  EXPECT_GE(squaredDistance(far, far), 0);
}

}  // namespace
}  // namespace restenosis
