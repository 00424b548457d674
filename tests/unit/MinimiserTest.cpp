#include <gtest/gtest.h>

#include "Minimiser.h"

namespace restenosis {
namespace {

/// One agent on a spring of unequal stiffness across and along the axis.
struct Spring {
  std::vector<Index> active{0};
  std::vector<Vec3> force{Vec3::Zero()}, velocity{Vec3::Zero()}, step{Vec3::Zero()};
  std::vector<double> stiffness{2.0}, radius{1.0};
  Vec3 position{0.3, -0.1, 0.2};

  double relax(Minimiser& minimiser, int steps) {
    double longest = 0;
    for (int k = 0; k < steps; ++k) {
      force[0] = -Vec3(2.0, 2.0, 0.5).cwiseProduct(position);
      minimiser.step({active, force, stiffness, radius, velocity, step});
      position += step[0];
      longest = std::max(longest, step[0].norm());
    }
    return longest;
  }
};

MechanicsParameters minimisedBy(std::string_view minimiser) {
  MechanicsParameters p;
  p.minimiser = minimiser;
  return p;
}

TEST(Minimiser, FindsTheBottomAndKeepsTheStepLimit) {
  for (const auto name : minimiserNames()) {
    Spring spring;
    const double longest = spring.relax(*makeMinimiser(minimisedBy(name)), 300);
    EXPECT_LT(spring.position.norm(), 1e-6) << name;
    EXPECT_LE(longest, 0.05 * (1 + 1e-12)) << name;
    EXPECT_GT(longest, 0.01) << name;
  }
}

TEST(Minimiser, MovesAlongTheAxisByTheAxialFactor) {
  for (const auto name : minimiserNames()) {
    Spring spring;
    spring.force[0] = {0.01, 0, 0.01};
    const auto minimiser = makeMinimiser(minimisedBy(name));
    minimiser->step(
        {spring.active, spring.force, spring.stiffness, spring.radius, spring.velocity, spring.step});
    EXPECT_NEAR(spring.step[0].z() / spring.step[0].x(), 2, 1e-12) << name;
  }
}

TEST(Minimiser, StopsAnAgentThatFeelsNoForce) {
  Spring spring;
  spring.velocity[0] = {0.1, 0, 0};
  makeMinimiser(minimisedBy("fire"))
      ->step({spring.active, spring.force, spring.stiffness, spring.radius, spring.velocity, spring.step});
  EXPECT_EQ(spring.step[0], Vec3::Zero());
}

TEST(Minimiser, SaysWhichNamesThereAre) {
  try {
    makeMinimiser(minimisedBy("newton"));
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(), "unknown minimiser 'newton'; known: fire, overdamped");
  }
}

}  // namespace
}  // namespace restenosis
