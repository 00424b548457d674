#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/biology/Biology.h"
#include "tissue/biology/Division.h"
#include "tissue/biology/ExtracellularMatrix.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double cube(double x) { return x * x * x; }

ExtracellularMatrixParameters parameters(double ratePerDay, double largestShare) {
  ExtracellularMatrixParameters p;
  p.rate = ratePerDay / oneDay, p.largestShare = largestShare;
  return p;
}

AgentStore oneCell() {
  AgentStore agents;
  agents.matrix.model(0);
  agents.append(AgentKind::smc, Vec3::Zero(), r);
  agents.set(0, synthetic, true);
  return agents;
}

TEST(ExtracellularMatrix, GrowsByTheRateOfTheVolumeAtBirth) {
  AgentStore agents = oneCell();
  const ExtracellularMatrix matrix(parameters(0.2, 0.9));
  for (int n = 0; n < 48; ++n) EXPECT_TRUE(matrix.deposit(agents, hour));
  EXPECT_NEAR(cube(agents.radius[0]) / cube(r), 1 + 0.2 * 2, 1e-6);
  EXPECT_NEAR(agents.cellRadius(0), r, 1e-12 * r);
  EXPECT_NEAR(agents.matrixShare(0), 0.4 / 1.4, 1e-6);
}

TEST(ExtracellularMatrix, FollowsActivation) {
  AgentStore agents = oneCell();
  agents.activation.model(1);
  agents.activation.set(0, 0.25F);
  const ExtracellularMatrix matrix(parameters(0.2, 0.9));
  EXPECT_TRUE(matrix.deposit(agents, oneDay));
  EXPECT_NEAR(cube(agents.radius[0]) / cube(r), 1 + 0.2 * 0.25, 1e-6);
}

TEST(ExtracellularMatrix, EndsAtTheLargestShare) {
  AgentStore agents = oneCell();
  const ExtracellularMatrix matrix(parameters(100, 0.6));
  EXPECT_TRUE(matrix.deposit(agents, oneDay));
  EXPECT_NEAR(agents.matrixShare(0), 0.6, 1e-6);
  EXPECT_FALSE(matrix.deposit(agents, oneDay));
  const ExtracellularMatrix none(parameters(100, 0));
  AgentStore other = oneCell();
  EXPECT_FALSE(none.deposit(other, oneDay));
  EXPECT_EQ(other.radius[0], r);
}

TEST(ExtracellularMatrix, IsNotLaidDownByContractileInhibitedOrFixedCells) {
  const ExtracellularMatrix matrix(parameters(1, 0.6));
  for (const AgentFlag flag : {synthetic, inhibited, fixed}) {
    AgentStore agents = oneCell();
    agents.set(0, flag, flag != synthetic);
    EXPECT_FALSE(matrix.deposit(agents, oneDay));
    EXPECT_EQ(agents.radius[0], r);
  }
}

TEST(ExtracellularMatrix, IsHalvedAtDivisionAndItsVolumeConserved) {
  AgentStore agents = oneCell();
  BondTable bonds;
  bonds.resize(1);
  const ExtracellularMatrix matrix(parameters(0.5, 0.6));
  matrix.deposit(agents, oneDay);
  agents.setCell(0, std::cbrt(2.0) * r, agents.matrix[0]);
  const double before = cube(agents.radius[0]);
  const std::vector<Index> mothers{0};
  Division(1, 0.4).divide(agents, bonds, mothers);
  ASSERT_EQ(agents.size(), 2U);
  EXPECT_NEAR((cube(agents.radius[0]) + cube(agents.radius[1])) / before, 1, 1e-12);
  EXPECT_EQ(agents.matrix[0], agents.matrix[1]);
  EXPECT_NEAR(agents.cellRadius(0), r, 1e-12 * r);
  EXPECT_EQ(agents.birthRadius[1], r);
}

TEST(ExtracellularMatrix, LeavesTheCyclesOfItsCellsAsTheyAre) {
  BiologySettings bare;
  bare.cellCycle.emplace();
  BiologySettings withMatrix = bare;
  withMatrix.extracellularMatrix = parameters(0.3, 0.6);
  std::vector<AgentStore> stores;
  for (const BiologySettings& settings : {bare, withMatrix}) {
    const Biology biology(settings);
    AgentStore agents;
    biology.model(agents);
    agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.set(0, synthetic, true);
    BondTable bonds;
    bonds.resize(1);
    for (int n = 0; n < 24 * 7; ++n) biology.advanceCycle(agents, bonds, n * hour);
    stores.push_back(agents);
  }
  ASSERT_EQ(stores[0].size(), stores[1].size());
  ASSERT_GT(stores[0].size(), 16U);
  for (Index i = 0; i < stores[0].size(); ++i) {
    EXPECT_EQ(stores[0].id[i], stores[1].id[i]);
    EXPECT_EQ(stores[0].state[i], stores[1].state[i]);
    EXPECT_EQ(stores[0].clock[i], stores[1].clock[i]);
    EXPECT_NEAR(stores[1].cellRadius(i), stores[0].radius[i], 1e-6 * r);
  }
}

}  // namespace
}  // namespace restenosis
