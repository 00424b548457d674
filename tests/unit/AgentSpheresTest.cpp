#include <gtest/gtest.h>

#include <array>

#include "tests/support/Constants.h"
#include "tissue/forces/AgentSpheres.h"

namespace restenosis {
namespace {

using support::r;

struct Two {
  AgentStore agents;
  BondTable bonds;
  Two() {
    agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.append(AgentKind::smc, Vec3(2 * r, 0, 0), r);
    bonds.resize(2);
  }
  AgentSpheres spheres(bool mixed) const {
    AgentSpheres copies(agents, bonds, mixed ? std::optional(FixedScale(r)) : std::nullopt);
    copies.copyAll();
    return copies;
  }
};

TEST(AgentSpheres, TellWhatHasChangedSinceTheyWereCopied) {
  for (const bool mixed : {false, true}) {
    Two two;
    AgentSpheres spheres = two.spheres(mixed);
    ASSERT_EQ(spheres.mixed(), mixed);
    EXPECT_FALSE(spheres.changed(1));
    two.agents.setPosition(1, Vec3(2 * r, 0.3 * r, -0.4 * r));
    two.agents.radius[1] = 1.25 * r;
    EXPECT_TRUE(spheres.changed(1));
    EXPECT_FALSE(spheres.changed(0));
    EXPECT_NEAR(spheres.changeOf(1).distance, 0.5 * r, 1e-6 * r);
    EXPECT_NEAR(spheres.changeOf(1).growth, 0.25 * r, 1e-6 * r);
    spheres.copy(1);
    EXPECT_FALSE(spheres.changed(1));
    EXPECT_EQ(spheres.changeOf(1).distance, 0);
  }
}

TEST(AgentSpheres, MoveWithAnAgentThatIsNotYetStored) {
  for (const bool mixed : {false, true}) {
    Two two;
    AgentSpheres spheres = two.spheres(mixed);
    const Vec3 there(2.5 * r, 0, 0);
    spheres.move(1, there, static_cast<float>(r));
    EXPECT_NEAR(spheres.changeOf(1).distance, 0.5 * r, 1e-6 * r);
    EXPECT_NEAR(spheres.squaredDistance(0, 1), 6.25 * r * r, 1e-6 * r * r);
    EXPECT_NEAR(spheres.radius(1), r, 1e-6 * r);
    two.agents.setPosition(1, there);
    EXPECT_FALSE(spheres.changed(1));
    spheres.visit([&](const auto& copies) {
      const std::array<Index, 16> ones{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, zeros{};
      typename std::decay_t<decltype(copies)>::Values dx, dy, dz;
      copies.separation(copies.at(ones.data()), copies.at(zeros.data()), dx, dy, dz);
      EXPECT_NEAR(dx[0], 2.5 * r, 1e-6 * r);
    });
  }
}

TEST(AgentSpheres, AreFollowedByASphereThatTouchesNothing) {
  const Two two;
  const AgentSpheres spheres = two.spheres(true);
  EXPECT_GE(spheres.none(), two.agents.size());
  spheres.visit([&](const auto& copies) {
    std::array<Index, 16> none;
    none.fill(spheres.none());
    EXPECT_LT(copies.at(none.data()).r[0], -1);
  });
}

TEST(AgentSpheres, AreInDoublePrecisionWhereABondIsLongerThanMixedPrecisionReaches) {
  Two two;
  two.bonds.connect(0, 1, 2 * r);
  two.agents.setPosition(1, Vec3(FixedScale(r).reach(), 0, 0));
  AgentSpheres spheres = two.spheres(true);
  EXPECT_FALSE(spheres.mixed());
  EXPECT_FALSE(spheres.precisionHolds({})) << "once it is short again, mixed precision is possible";

  two.agents.setPosition(1, Vec3(2 * r, 0, 0));
  spheres.copyAll();
  EXPECT_TRUE(spheres.mixed());
  EXPECT_TRUE(spheres.precisionHolds({}));
}

TEST(AgentSpheres, TellWhenAnAgentHasBecomeTooLargeForMixedPrecision) {
  Two two;
  const AgentSpheres spheres = two.spheres(true), exact = two.spheres(false);
  two.agents.radius[0] = FixedScale(r).reach() / 2;
  EXPECT_FALSE(spheres.precisionHolds(std::array<Index, 2>{0, 1}));
  EXPECT_TRUE(spheres.precisionHolds(std::array<Index, 1>{1}));
  EXPECT_TRUE(exact.precisionHolds(std::array<Index, 2>{0, 1}));
}

}  // namespace
}  // namespace restenosis
