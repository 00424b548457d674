#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

#include "tissue/agents/FixedScale.h"

namespace restenosis {
namespace {

constexpr double length = 15e-6;

TEST(FixedScale, UnitIsThePowerOfTwoBelowALengthOverFourMillion) {
  const FixedScale scale(length);
  EXPECT_LE(scale.unit(), length * 0x1p-22);
  EXPECT_GT(2 * scale.unit(), length * 0x1p-22);
  EXPECT_EQ(scale.reach(), scale.unit() * 0x1p31);
}

std::array<std::uint32_t, 3> between(const FixedPlace& a, const FixedPlace& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

TEST(FixedScale, TellsDifferencesAlikeWhereverInSpace) {
  const FixedScale scale(length);
  const Vec3 apart = scale.unit() * Vec3(1 << 20, 3, 1 << 10);
  // Whole numbers of units, some of them many periods away
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(Vec3::Constant(scale.unit() * 0x1p36)),
                            Vec3(Vec3::Constant(-scale.unit() * 0x1.8p34))}) {
    EXPECT_EQ(between(scale.of(place), scale.of(place + apart)),
              (std::array<std::uint32_t, 3>{1 << 20, 3, 1 << 10}));
    EXPECT_EQ(between(scale.of(place + apart), scale.of(place))[1], static_cast<std::uint32_t>(-3));
  }
}

TEST(FixedScale, TakesNumbersOfAnySize) {
  const FixedScale scale(length);
  constexpr double most = std::numeric_limits<double>::max();
  const FixedPlace far = scale.of(Vec3(most, -most, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(far.z, 0u);
  EXPECT_EQ(between(far, scale.of(Vec3(most, -most, 0))), (std::array<std::uint32_t, 3>{0, 0, 0}));
}

}  // namespace
}  // namespace restenosis
