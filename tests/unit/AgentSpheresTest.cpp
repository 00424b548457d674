#include <gtest/gtest.h>

#include <array>

#include "tests/support/Constants.h"
#include "tissue/equilibrium/AgentSpheres.h"

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
    return {agents, bonds, mixed ? std::optional(FixedScale(r)) : std::nullopt};
  }
};

TEST(AgentSpheres, InMixedPrecisionRemembersWhereAnAgentWas) {
  Two two;
  AgentSpheres spheres = two.spheres(true);
  spheres.choosePrecision();
  spheres.packAll();
  ASSERT_TRUE(spheres.mixed());

  const Vec3 there(2.5 * r, 0, 0);
  spheres.moveTo(1, there, static_cast<float>(r));
  EXPECT_EQ(spheres.remembered(1).x, 2 * r);
  two.agents.setPosition(1, there);
  EXPECT_TRUE(spheres.changed(1));
  EXPECT_FALSE(spheres.changed(0));
  spheres.remember(std::array<Index, 1>{1});
  EXPECT_EQ(spheres.remembered(1).x, there.x());
  EXPECT_FALSE(spheres.changed(1));
}

TEST(AgentSpheres, InDoublePrecisionHasOneCopy) {
  const Two two;
  AgentSpheres spheres = two.spheres(false);
  spheres.choosePrecision();
  spheres.packAll();
  EXPECT_FALSE(spheres.mixed());
  spheres.moveTo(1, Vec3(2.5 * r, 0, 0), static_cast<float>(r));
  EXPECT_EQ(spheres.remembered(1).x, 2.5 * r);
}

TEST(AgentSpheres, IsInDoublePrecisionWhereABondIsLongerThanMixedPrecisionReaches) {
  Two two;
  two.bonds.connect(0, 1, 2 * r);
  two.agents.setPosition(1, Vec3(FixedScale(r).reach(), 0, 0));
  AgentSpheres spheres = two.spheres(true);
  spheres.choosePrecision();
  EXPECT_FALSE(spheres.mixed());
  EXPECT_TRUE(spheres.outgrown()) << "once it is short again, mixed precision is possible";

  two.agents.setPosition(1, Vec3(2 * r, 0, 0));
  spheres.choosePrecision();
  EXPECT_TRUE(spheres.mixed());
  EXPECT_FALSE(spheres.outgrown());
}

TEST(AgentSpheres, IsOutgrownByAnAgentThatBecomesTooLarge) {
  Two two;
  AgentSpheres spheres = two.spheres(true);
  spheres.choosePrecision();
  spheres.packAll();
  two.agents.radius[0] = FixedScale(r).reach() / 2;
  EXPECT_FALSE(spheres.fit(std::array<Index, 2>{0, 1}));
  EXPECT_TRUE(spheres.fit(std::array<Index, 1>{1}));
  EXPECT_FALSE(spheres.outgrown());
  spheres.remember(std::array<Index, 1>{0});
  EXPECT_TRUE(spheres.outgrown());
}

}  // namespace
}  // namespace restenosis
