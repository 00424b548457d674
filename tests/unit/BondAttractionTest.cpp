#include <gtest/gtest.h>

#include "tissue/forces/BondAttraction.h"

namespace restenosis {
namespace {

constexpr double rest = 28e-6, sum = 30e-6;

TEST(BondAttraction, PullsInTensionOnly) {
  const BondAttraction bond{2.18e6, 1};
  EXPECT_EQ(bond.pull(0.9 * rest, rest, sum, 0), 0);
  EXPECT_EQ(bond.pull(rest, rest, sum, 0), 0);
  EXPECT_DOUBLE_EQ(bond.pull(1.125 * rest, rest, sum, 0), 2.18e6 * 0.125 * sum * sum);
}

TEST(BondAttraction, ForceIsTheSlopeOfTheEnergy) {
  const BondAttraction bond{2.18e6, 1};
  for (const double distance : {0.9 * rest, 1.1 * rest, 2 * rest}) {
    const double h = 1e-6 * rest;
    const double slope =
        (bond.energy(distance + h, rest, sum) - bond.energy(distance - h, rest, sum)) / (2 * h);
    EXPECT_NEAR(slope, bond.pull(distance, rest, sum, 0), 1e-12);
  }
}

TEST(BondAttraction, IsStifferAlongTheAxisByTheAxialFactor) {
  const BondAttraction plain{1e6, 1}, axial{1e6, 3};
  const auto ratio = [&](double cosine2) {
    return axial.pull(1.1 * rest, rest, sum, cosine2) / plain.pull(1.1 * rest, rest, sum, cosine2);
  };
  EXPECT_DOUBLE_EQ(ratio(0), 1);
  EXPECT_DOUBLE_EQ(ratio(0.5), 2);
  EXPECT_DOUBLE_EQ(ratio(1), 3);
}

}  // namespace
}  // namespace restenosis
