#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/stent/DeploymentStatistics.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

class MeasuredWall : public testing::Test {
 protected:
  MeasuredWall() {
    VesselParameters vessel;
    vessel.cellRadius = r;
    wall = emptyWall(vessel);
    stent.segments.push_back({.a = {1e-3, 0, 0.1e-3},
                              .b = {1e-3, 0, 0.3e-3},
                              .radial = Vec3::UnitX(),
                              .width = 80e-6,
                              .thickness = 60e-6,
                              .round = false});
  }
  Index add(AgentKind kind, const Vec3& place) {
    const Index i = wall.agents.append(kind, place, r);
    wall.bonds.resize(wall.agents.size());
    return i;
  }
  DeploymentStatistics measured() const { return measureDeployment(wall, stent); }

  Wall wall;
  Stent stent;
};

TEST_F(MeasuredWall, MeansOverNothingAreAbsent) {
  const DeploymentStatistics result = measured();
  EXPECT_FALSE(result.ielUnderStrut || result.laminaDistance || result.meanIelStrain || result.meanStrain);
  EXPECT_EQ(result.largestOverlap, 0);
  EXPECT_EQ(result.outside, 0u);
}

TEST_F(MeasuredWall, LaminaeAreMeasuredUnderTheMiddleOfStruts) {
  add(AgentKind::iel, {1.04e-3, 0, 0.2e-3});
  add(AgentKind::iel, {1.06e-3, 0, 0.25e-3});
  add(AgentKind::iel, toCartesian({1.2e-3, 0.025, 0.2e-3}));  // beyond a quarter of the width
  EXPECT_NEAR(measured().ielUnderStrut.value(), 1.05e-3, 1e-15);
  EXPECT_FALSE(measured().laminaDistance);
  add(AgentKind::eel, {1.20e-3, 0, 0.2e-3});
  EXPECT_NEAR(measured().laminaDistance.value(), 0.15e-3, 1e-15);
}

TEST_F(MeasuredWall, OverlapIsOfTheClosestPairThatIsNotOfStruts) {
  add(AgentKind::smc, {1.5e-3, 0, 0});
  add(AgentKind::smc, {1.5e-3, 0, 1.7 * r});
  EXPECT_NEAR(measured().largestOverlap, 0.3, 1e-9);
  add(AgentKind::strut, {1.5e-3, 1.6 * r, 0});
  EXPECT_NEAR(measured().largestOverlap, 0.4, 1e-9);
  add(AgentKind::strut, {1.5e-3, 2.6 * r, 0});
  EXPECT_NEAR(measured().largestOverlap, 0.4, 1e-9) << "two struts";
}

TEST_F(MeasuredWall, StrainIsThatOfAllBondsAndOfTheIel) {
  const auto bonded = [&](AgentKind kind, double y, double strain) {
    const Index a = add(kind, {1.5e-3, y, 0}), b = add(kind, {1.5e-3, y, 2 * r});
    wall.bonds.connect(a, b, 2 * r / (1 + strain));
  };
  bonded(AgentKind::iel, 0, 0.1);
  bonded(AgentKind::iel, 1e-3, -0.04);
  bonded(AgentKind::smc, 2e-3, 0.3);
  const DeploymentStatistics result = measured();
  constexpr double rounding = 1e-7;  // rest lengths are in single precision
  EXPECT_NEAR(result.meanIelStrain.value(), 0.03, rounding);
  EXPECT_NEAR(result.largestIelStrain, 0.1, rounding);
  EXPECT_NEAR(result.meanStrain.value(), 0.12, rounding);
  EXPECT_NEAR(result.largestStrain, 0.3, rounding);
}

TEST_F(MeasuredWall, CellsBeyondTheEelAreOutside) {
  for (int n = 0; n < 250; ++n) add(AgentKind::eel, toCartesian({1.1e-3, 2 * pi * n / 250, 0.2e-3}));
  add(AgentKind::smc, {0, 1.09e-3, 0.2e-3});
  EXPECT_EQ(measured().outside, 0u);
  add(AgentKind::smc, {0, -1.11e-3, 0.2e-3});
  add(AgentKind::iel, {-1.11e-3, 0, 0.2e-3});
  EXPECT_EQ(measured().outside, 1u) << "cells only";
}

}  // namespace
}  // namespace restenosis
