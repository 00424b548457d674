#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tissue/agents/RandomStream.h"
#include "tissue/biology/Division.h"
#include "tissue/biology/Endothelium.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {
namespace {

constexpr double day = 86400;

AgentStore exposedCells(Index n) {
  AgentStore agents;
  for (Index i = 0; i < n; ++i) {
    agents.append(AgentKind::smc, Vec3(1e-5 * i, 0, 0), 15e-6);
    agents.set(i, exposed, true);
    agents.set(i, synthetic, true);
  }
  return agents;
}

TEST(EndotheliumVerification, CoverageFollowsEveryScenario) {
  for (const auto& scenario : endotheliumScenarios()) {
    EndotheliumParameters parameters;
    parameters.scenario = scenario.name;
    const Endothelium endothelium(parameters, 1, true);
    AgentStore agents = exposedCells(3000);
    for (int hour = 0; hour <= 25 * 24; ++hour) {
      endothelium.apply(agents, hour * 3600.0);
      EXPECT_NEAR(countStates(agents).coverage(), scenario.coverage(hour * 3600.0), 0.5 / 3000 + 1e-12)
          << scenario.name << ", hour " << hour;
    }
  }
}

/// Bare cells divide about every 32 h and covered ones every 32 h / `coveredSlower`; the surface holds 2000
/// cells, so as many are buried at random. Returns the largest excess and deficit of coverage over the
/// scenario.
std::pair<double, double> deviations(double coveredSlower) {
  const Endothelium endothelium({}, 1, true);
  const Division division(1, 0.4);
  AgentStore agents = exposedCells(2000);
  BondTable bonds;
  bonds.resize(agents.size());
  double excess = 0, deficit = 0;
  for (std::uint32_t hour = 0; hour <= 25 * 24; ++hour) {
    endothelium.apply(agents, hour * 3600.0);
    const StateCounts counts = countStates(agents);
    const double difference = counts.coverage() - endothelium.target(hour * 3600.0);
    excess = std::max(excess, difference);
    deficit = std::max(deficit, -difference);
    if (endothelium.target(hour * 3600.0) >= 1) {
      EXPECT_EQ(counts.coveredExposed, counts.exposedSynthetic);
    }

    std::vector<Index> mothers;
    for (Index i = 0; i < agents.size(); ++i) {
      RandomStream random(9, agents.id[i], hour, RandomPurpose::g1Duration);
      const double rate = agents.has(i, covered) ? coveredSlower / 32 : 1.0 / 32;
      if (random.uniform() < rate) mothers.push_back(i);
    }
    division.divide(agents, bonds, mothers);
    std::vector<std::uint8_t> buried(agents.size(), 0);
    for (Index i = 0; i < agents.size(); ++i) {
      agents.set(i, exposed, true);
      RandomStream random(9, agents.id[i], hour, RandomPurpose::packing);
      buried[i] = random.uniform() < 1 - 2000.0 / agents.size();
    }
    agents.erase(buried);
    bonds.erase(buried);
    bonds.resize(agents.size());
  }
  return {excess, deficit};
}

TEST(EndotheliumVerification, CoverageFollowsTheScenarioWhileCellsDivideAndAreBuried) {
  // Half a cell of 1500 at the least; burial at random shifts the share of the rest by no more than it does
  // by chance.
  for (const double coveredSlower : {0.0, 1.0}) {
    const auto [excess, deficit] = deviations(coveredSlower);
    EXPECT_LT(deficit, 0.5 / 1500) << coveredSlower;
    EXPECT_LT(excess, 5 * std::sqrt(0.59 * 0.41 / 2000)) << coveredSlower;
  }
}

}  // namespace
}  // namespace restenosis
