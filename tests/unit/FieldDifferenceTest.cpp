#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bridge/compare/FieldDifference.h"

namespace restenosis {
namespace {

TEST(FieldDifference, twoFacesByHand) {
  FieldDifferenceSum sum;
  sum.add(1.0, 1.1, 3.0);
  sum.add(2.0, 1.8, 1.0);
  const auto d = sum.result();
  EXPECT_EQ(d.count, 2u);
  EXPECT_DOUBLE_EQ(d.weight, 4.0);
  EXPECT_DOUBLE_EQ(d.referenceMean, 1.25);
  EXPECT_DOUBLE_EQ(d.mean, 1.275);
  EXPECT_NEAR(d.meanDifference, 0.02, 1e-12);
  EXPECT_NEAR(d.relativeL2, std::sqrt((3 * 0.01 + 0.04) / (3 + 4)), 1e-12);
  EXPECT_NEAR(d.correlation, 1.0, 1e-12);
  EXPECT_NEAR(d.bias, 0.025, 1e-12);
  const double deviation = std::sqrt((3 * 0.01 + 0.04) / 4 - 0.025 * 0.025);
  EXPECT_NEAR(d.upperLimit, 0.025 + 1.96 * deviation, 1e-12);
  EXPECT_NEAR(d.lowerLimit, 0.025 - 1.96 * deviation, 1e-12);
  EXPECT_NEAR(d.relativeP95, 0.2 / 1.9, 1e-12);
}

TEST(FieldDifference, oppositeFieldsCorrelateNegatively) {
  FieldDifferenceSum sum;
  sum.add(1.0, 2.0, 1.0);
  sum.add(2.0, 1.0, 1.0);
  EXPECT_NEAR(sum.result().correlation, -1.0, 1e-12);
  EXPECT_NEAR(sum.result().meanDifference, 0.0, 1e-12);
}

TEST(FieldDifference, ninetyFifthPercentileGoesByWeight) {
  FieldDifferenceSum sum;
  sum.add(1.0, 1.0, 94.0);
  sum.add(1.0, 3.0, 2.0);
  sum.add(1.0, 9.0, 4.0);
  EXPECT_DOUBLE_EQ(sum.result().relativeP95, 1.0);
}

TEST(FieldDifference, unknownPairsAreCountedAndLeftOut) {
  FieldDifferenceSum sum;
  sum.add(1.0, std::numeric_limits<double>::quiet_NaN(), 1.0);
  EXPECT_EQ(sum.unknown(), 1u);
  EXPECT_EQ(sum.result().count, 0u);
  EXPECT_EQ(sum.result().relativeL2, 0.0);
}

TEST(FieldDifference, equalFieldsDifferInNothing) {
  FieldDifferenceSum sum;
  for (const double v : {0.0, 1.0, 2.0}) sum.add(v, v, 1.0);
  const auto d = sum.result();
  EXPECT_EQ(d.relativeL2, 0.0);
  EXPECT_EQ(d.relativeP95, 0.0);
  EXPECT_NEAR(d.correlation, 1.0, 1e-12);
}

}  // namespace
}  // namespace restenosis
