#include <gtest/gtest.h>

#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {
namespace {

AgentStore lamina(double (*radius)(double angle, double z)) {
  AgentStore agents;
  for (int k = 0; k <= 20; ++k) {
    for (int n = 0; n < 200; ++n) {
      const double angle = 2 * std::numbers::pi * n / 200, z = 25e-6 * k;
      agents.append(AgentKind::eel, toCartesian({radius(angle, z), angle, z}), 15e-6);
    }
  }
  return agents;
}

TEST(RadiusMap, IsExactForACylinder) {
  const AgentStore agents = lamina([](double, double) { return 1e-3; });
  const RadiusMap map(agents, AgentKind::eel, 30e-6);
  for (const double angle : {-3.1, -1.0, 0.0, 2.0, 3.14159}) {
    for (const double z : {-1e-4, 0.0, 1.234e-4, 5e-4, 1e-3}) {
      EXPECT_NEAR(map.at(toCartesian({2e-3, angle, z})), 1e-3, 1e-12);
    }
  }
}

TEST(RadiusMap, FollowsASmoothSurfaceAcrossTheSeam) {
  const auto wavy = [](double angle, double z) {
    return 1e-3 + 50e-6 * std::cos(2 * angle) + 0.05 * (z - 250e-6);
  };
  const RadiusMap map(lamina(wavy), AgentKind::eel, 30e-6);
  for (double angle = -3.2; angle < 3.2; angle += 0.1) {
    EXPECT_NEAR(map.at(toCartesian({1e-3, angle, 250e-6})), wavy(angle, 250e-6), 0.5e-6);
  }
}

TEST(RadiusMap, BoundsItselfFromBelowAndClosely) {
  const auto bulged = [](double angle, double z) {
    return 1e-3 + 100e-6 * std::exp(-10 * (angle - 3) * (angle - 3)) + 0.1 * z;
  };
  const RadiusMap map(lamina(bulged), AgentKind::eel, 30e-6);
  double gap = 0;
  int points = 0;
  for (double angle = -std::numbers::pi; angle <= std::numbers::pi; angle += 0.001) {
    for (const double z : {-1e-4, 0.0, 1.01e-4, 2.5e-4, 4.99e-4, 5e-4, 1e-3}) {
      const Vec3 point = toCartesian({0.7e-3, angle, z});
      const double bound = map.lowestNear(point.x(), point.y(), point.z());
      ASSERT_LE(bound, map.at(point)) << angle << ' ' << z;
      gap += map.at(point) - bound;
      ++points;
    }
  }
  EXPECT_LT(gap / points, 10e-6) << "a bound too low is of no use";
  EXPECT_TRUE(std::isinf(RadiusMap(AgentStore(), AgentKind::eel, 30e-6).lowestNear(1, 0, 0)));
}

TEST(RadiusMap, ContinuesIntoGapsAndIsInfiniteWithoutAgents) {
  AgentStore agents;
  agents.append(AgentKind::eel, {1e-3, 0, 0}, 15e-6);
  agents.append(AgentKind::eel, {1e-3, 0, 1e-3}, 15e-6);
  const RadiusMap map(agents, AgentKind::eel, 30e-6);
  EXPECT_NEAR(map.at({-1e-3, 0, 5e-4}), 1e-3, 1e-12);
  EXPECT_TRUE(std::isinf(RadiusMap(agents, AgentKind::iel, 30e-6).at({1, 0, 0})));
}

}  // namespace
}  // namespace restenosis
