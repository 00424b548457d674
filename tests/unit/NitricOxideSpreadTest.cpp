#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/biology/NitricOxide.h"
#include "tissue/biology/NitricOxideSpread.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double reach = 6 * r, negligible = 1e-5;

AgentStore cellsAtRandom(Index count) {
  AgentStore agents;
  RandomStream random(1, 0, 0, RandomPurpose::packing);
  for (Index i = 0; i < count; ++i) {
    agents.append(AgentKind::smc, 40 * r * Vec3(random.uniform(), random.uniform(), random.uniform()), r);
    agents.set(i, synthetic, true);
    if (i % 7 == 0) agents.nitricOxide[i] = 0.02 * random.uniform();
  }
  return agents;
}

TEST(NitricOxideSpread, IsTheLargestThatReachesACell) {
  AgentStore agents = cellsAtRandom(1500);
  const AgentStore before = agents;
  spreadNitricOxide(agents, reach, negligible);
  for (Index i = 0; i < agents.size(); ++i) {
    double largest = before.nitricOxide[i];
    for (Index j = 0; j < agents.size(); ++j) {
      const double distance = (agents.position(i) - agents.position(j)).norm();
      const double arriving = before.nitricOxide[j] * std::exp(-distance / reach);
      if (arriving > negligible) largest = std::max(largest, arriving);
    }
    EXPECT_NEAR(agents.nitricOxide[i], largest, 1e-12) << i;
  }
}

TEST(NitricOxideSpread, ReachesFreeSyntheticCellsOnly) {
  AgentStore agents;
  for (int n = 0; n < 5; ++n) {
    agents.append(n == 4 ? AgentKind::iel : AgentKind::smc, Vec3(n * r, 0, 0), r);
    agents.set(n, synthetic, n != 2);
  }
  agents.set(3, fixed, true);
  agents.nitricOxide[0] = 1;
  spreadNitricOxide(agents, reach, negligible);
  EXPECT_NEAR(agents.nitricOxide[1], std::exp(-r / reach), 1e-12);
  for (const Index i : {2, 3, 4}) EXPECT_EQ(agents.nitricOxide[i], 0) << i;
}

TEST(NitricOxideSpread, IsThatOfTheCellAloneForATinyReachAndOfTheStrongestForAHugeOne) {
  AgentStore tiny = cellsAtRandom(300), huge = tiny;
  const AgentStore before = tiny;
  spreadNitricOxide(tiny, 1e-12, negligible);
  EXPECT_EQ(tiny.nitricOxide, before.nitricOxide);
  spreadNitricOxide(huge, 1e3, negligible);
  const double strongest = std::ranges::max(before.nitricOxide);
  for (const double value : huge.nitricOxide) EXPECT_NEAR(value, strongest, 1e-6 * strongest);
  AgentStore none;
  spreadNitricOxide(none, reach, negligible);
}

TEST(NitricOxide, SpreadsFromCoveredCellsByTheirStressAndMaturity) {
  EndotheliumParameters parameters;
  parameters.nitricOxideReach = reach;
  AgentStore agents;
  agents.maturity.model(0);
  for (int n = 0; n < 2; ++n) {
    agents.append(AgentKind::smc, Vec3(n * 2 * r, 0, 0), r);
    agents.set(n, synthetic, true);
    agents.wss[n] = 1;
  }
  agents.set(0, covered, true);
  agents.maturity.set(0, 0.5F);
  NitricOxide(parameters).apply(agents);
  EXPECT_NEAR(agents.nitricOxide[0], 0.00366 / 2, 1e-12);
  EXPECT_NEAR(agents.nitricOxide[1], 0.00366 / 2 * std::exp(-2 * r / reach), 1e-12);
}

}  // namespace
}  // namespace restenosis
