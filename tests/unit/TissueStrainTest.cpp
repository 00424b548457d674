#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/stent/TissueStrain.h"

namespace restenosis {
namespace {

using namespace support;

/// Agents at random in a block beside the axis.
AgentStore block(int count) {
  AgentStore agents;
  RandomStream random(1, 0, 0, RandomPurpose::packing);
  for (int n = 0; n < count; ++n) {
    const Vec3 place(random.uniform(), random.uniform(), random.uniform());
    agents.append(AgentKind::smc, Vec3(60 * r, 0, 0) + 12 * r * place, r);
  }
  return agents;
}

std::vector<double> placesOf(const AgentStore& agents) {
  std::vector<double> places;
  for (Index i = 0; i < agents.size(); ++i)
    places.insert(places.end(), {agents.x[i], agents.y[i], agents.z[i]});
  return places;
}

TEST(TissueStrain, IsThatOfAnAffineDeformation) {
  AgentStore agents = block(400);
  const std::vector<double> packed = placesOf(agents);
  Eigen::Matrix3d gradient;
  gradient << 0.8, 0.1, 0.0, -0.2, 1.3, 0.05, 0.0, 0.1, 1.1;
  for (Index i = 0; i < agents.size(); ++i)
    agents.setPosition(i, gradient * agents.position(i) + Vec3(r, 2 * r, -r));
  agents.append(AgentKind::strut, Vec3(60 * r, 0, 0), r);
  const std::vector<double> strain = strainAroundVessel(agents, packed);
  ASSERT_EQ(strain.size(), agents.size());
  for (Index i = 0; i + 1 < agents.size(); ++i) {
    const Vec3 around = Vec3(-packed[3 * i + 1], packed[3 * i], 0).normalized();
    EXPECT_NEAR(strain[i], (gradient * around).norm() - 1, 1e-9) << i;
  }
  EXPECT_EQ(strain.back(), 0);
}

TEST(TissueStrain, IsNothingForAWallThatHasNotMovedOrHasTurned) {
  AgentStore agents = block(200);
  const std::vector<double> packed = placesOf(agents);
  for (const double strain : strainAroundVessel(agents, packed)) EXPECT_NEAR(strain, 0, 1e-9);
  const Eigen::AngleAxisd turn(1, Vec3(1, 2, 3).normalized());
  for (Index i = 0; i < agents.size(); ++i) agents.setPosition(i, turn * agents.position(i));
  for (const double strain : strainAroundVessel(agents, packed)) EXPECT_NEAR(strain, 0, 1e-9);
}

TEST(TissueStrain, IsNothingWhereNeighboursDoNotDetermineIt) {
  AgentStore agents;
  for (int n = 0; n < 4; ++n) agents.append(AgentKind::smc, Vec3(10 * r, 2 * r * n, 0), r);  // a row
  agents.append(AgentKind::smc, Vec3(90 * r, 0, 0), r);                                      // and one alone
  const std::vector<double> packed = placesOf(agents);
  for (Index i = 0; i < agents.size(); ++i) agents.setPosition(i, 2 * agents.position(i));
  for (const double strain : strainAroundVessel(agents, packed)) EXPECT_EQ(strain, 0);
  EXPECT_EQ(strainAroundVessel(agents, {}), std::vector<double>(agents.size(), 0.0));
}

}  // namespace
}  // namespace restenosis
