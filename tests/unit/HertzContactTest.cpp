#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/Constants.h"
#include "tissue/forces/HertzContact.h"

namespace restenosis {
namespace {

using namespace support;

TEST(HertzContact, IsTheClosedForm) {
  const HertzContact law(modulus);
  const double d = 1e-6, E = 6 * modulus;
  EXPECT_DOUBLE_EQ(forceOf(law, d, R), 4.0 / 3.0 * E * std::sqrt(R) * std::pow(d, 1.5));
  EXPECT_EQ(forceOf(law, 0.0, R), 0.0);
}

TEST(HertzContact, ForceIsTheSlopeOfTheEnergyAndStiffnessThatOfTheForce) {
  const HertzContact law(modulus);
  for (const double d : {0.01 * R, 0.3 * R, 2 * R, 50 * R}) {
    const double h = 1e-5 * d;
    EXPECT_NEAR((law.energy(d + h, R) - law.energy(d - h, R)) / (2 * h) / forceOf(law, d, R), 1, 1e-8);
    EXPECT_NEAR((forceOf(law, d + h, R) - forceOf(law, d - h, R)) / (2 * h) / stiffnessOf(law, d, R), 1,
                1e-8);
  }
}

}  // namespace
}  // namespace restenosis
