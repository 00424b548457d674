#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/Constants.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"

namespace restenosis {
namespace {

using namespace support;

TEST(HertzNeoHookeanContact, IsThePublishedFormula) {
  const HertzNeoHookeanContact law(modulus);
  for (const double d : {0.01 * R, 0.5 * R, 2 * R, 4 * R}) {
    const double a = std::sqrt(R * d);
    const double published = 8 * a * a * a * modulus * (16 * a * a - 36 * pi * a * R + 27 * pi * pi * R * R) /
                             (3 * R * std::pow(4 * a - 3 * pi * R, 2));
    EXPECT_NEAR(forceOf(law, d, R) / published, 1, 1e-12) << d / R;
  }
}

TEST(HertzNeoHookeanContact, HasTheTabulatedRatiosToHertz) {
  const double radius = 15e-6;
  const double table[][2] = {{0.01, 1.065}, {0.1, 1.253}, {0.2, 1.412}, {0.5, 1.919}, {1.2, 4.148}};
  for (const auto& [overlap, ratio] : table) {
    const double d = overlap * radius;
    EXPECT_NEAR(forceOf(HertzNeoHookeanContact(modulus), d, radius / 2) /
                    forceOf(HertzContact(modulus), d, radius / 2),
                ratio, 0.5e-3)
        << overlap;
  }
}

TEST(HertzNeoHookeanContact, ForceIsTheSlopeOfTheEnergyAndStiffnessThatOfTheForce) {
  const HertzNeoHookeanContact law(modulus);
  // Includes both forms of the energy, the beginning of the continuation and what lies beyond the pole
  // at 5.55 R.
  for (const double d : {0.001 * R, 0.1 * R, 0.22 * R, 0.23 * R, 2 * R, 3.9 * R, 4.1 * R, 5.6 * R, 100 * R}) {
    const double h = 1e-6 * d;
    EXPECT_NEAR((law.energy(d + h, R) - law.energy(d - h, R)) / (2 * h) / forceOf(law, d, R), 1, 2e-6)
        << d / R;
    EXPECT_NEAR((forceOf(law, d + h, R) - forceOf(law, d - h, R)) / (2 * h) / stiffnessOf(law, d, R), 1, 1e-6)
        << d / R;
  }
}

TEST(HertzNeoHookeanContact, IsContinuousWhereTheFormsOfItsEnergyMeet) {
  const HertzNeoHookeanContact law(modulus);
  const double meeting = 9 * std::numbers::pi * std::numbers::pi / 16 * R * 0.04;  // e = 0.2
  EXPECT_NEAR(law.energy(meeting * (1 + 1e-13), R) / law.energy(meeting * (1 - 1e-13), R), 1, 1e-10);
}

TEST(HertzNeoHookeanContact, StaysFiniteRepulsiveAndMonotoneForRadiiOfOneToAHundred) {
  const HertzNeoHookeanContact law(modulus);
  for (const double ratio : {1.0, 3.0, 10.0, 100.0}) {
    const double small = 1e-6, large = ratio * small, reduced = small * large / (small + large);
    double before = 0;
    for (int k = 1; k <= 1000; ++k) {
      const double d = (small + large) * k / 1000;  // up to coinciding centres
      const double force = forceOf(law, d, reduced);
      ASSERT_TRUE(std::isfinite(force));
      ASSERT_GT(force, before) << ratio << ' ' << k;
      before = force;
    }
  }
}

TEST(HertzNeoHookeanContact, NeverReachesItsContinuationForEqualRadii) {
  EXPECT_GT(HertzNeoHookeanContact::validOverlap(R), 4 * R);
}

}  // namespace
}  // namespace restenosis
