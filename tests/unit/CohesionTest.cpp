#include <gtest/gtest.h>

#include "tissue/forces/Cohesion.h"

namespace restenosis {
namespace {

constexpr double touching = 30e-6;

TEST(Cohesion, IsATriangleOverTheGap) {
  const Cohesion cohesion{0.02e6, 1.2};
  const double end = 0.2 * touching;
  EXPECT_EQ(cohesion.pull(-1e-6, touching), 0);
  EXPECT_EQ(cohesion.pull(0, touching), 0);
  EXPECT_NEAR(cohesion.pull(end / 2, touching), 0.02e6 * touching * end / 2, 1e-18);
  EXPECT_NEAR(cohesion.pull(0.75 * end, touching), cohesion.pull(0.25 * end, touching), 1e-18);
  EXPECT_EQ(cohesion.pull(1.0001 * end, touching), 0);
  EXPECT_EQ((Cohesion{0.02e6, 1}.pull(1e-7, touching)), 0);
}

TEST(Cohesion, ForceIsTheSlopeOfTheEnergy) {
  const Cohesion cohesion{0.02e6, 1.2};
  for (const double share : {-0.1, 0.05, 0.45, 0.55, 0.95, 1.1}) {
    const double gap = share * 0.2 * touching, h = 1e-6 * touching;
    const double slope = (cohesion.energy(gap + h, touching) - cohesion.energy(gap - h, touching)) / (2 * h);
    EXPECT_NEAR(slope, cohesion.pull(gap, touching), 1e-6 * cohesion.pull(0.1 * touching, touching)) << share;
  }
}

}  // namespace
}  // namespace restenosis
