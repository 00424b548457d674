#include <gtest/gtest.h>

#include <cmath>

#include "bridge/flow/lbm/SteadyState.h"

namespace restenosis {
namespace {

/// Samples of a quantity that tends to 1 and is off by e^-k at the k-th.
double estimate(double ratio, int samples) {
  SteadyState steady;
  for (int k = 0; k < samples; ++k) steady.add({1.0 + std::pow(ratio, k)});
  return steady.distance();
}

TEST(SteadyState, knowsNothingBeforeNineSamples) {
  EXPECT_TRUE(std::isinf(estimate(0.5, 8)));
  EXPECT_FALSE(std::isinf(estimate(0.5, 9)));
}

TEST(SteadyState, isNotBelowTheTrueDistanceOfADecay) {
  for (const double ratio : {0.6, 0.8, 0.9, 0.95}) {
    const double distance = std::pow(ratio, 29);
    const double found = estimate(ratio, 30);
    EXPECT_GE(found, 0.95 * distance) << ratio;
    EXPECT_LE(found, 40.0 * distance) << ratio;
  }
}

TEST(SteadyState, isZeroOnceNothingChanges) {
  SteadyState steady;
  for (int k = 0; k < 12; ++k) steady.add({1.0, 2.0});
  EXPECT_EQ(steady.distance(), 0.0);
}

TEST(SteadyState, aFlowAtRestIsSteady) {
  SteadyState steady;
  for (int k = 0; k < 12; ++k) steady.add({0.0});
  EXPECT_EQ(steady.distance(), 0.0);
}

}  // namespace
}  // namespace restenosis
