#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/Constants.h"
#include "tissue/biology/CellCycle.h"
#include "tissue/biology/Division.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore syntheticCells(Index n) {
  AgentStore agents;
  for (Index i = 0; i < n; ++i) {
    agents.append(AgentKind::smc, Vec3(1e-4 * i, 0, 0), 15e-6);
    agents.set(i, synthetic, true);
  }
  return agents;
}

const ArrestRules rules{BiologySettings{}};

/// The moment a cell divided is the end of the step less what the step left over.
class CellCycleStep : public ::testing::TestWithParam<double> {};

TEST_P(CellCycleStep, MeanTimeToTheFourthDivisionIsFourTimesBothPhases) {
  const double step = GetParam() * hour;
  const Index n = 4000;
  const std::uint32_t generations = 4;
  const CellCycle cycle({}, 11, step);
  const Division division(11, 0.4);
  AgentStore agents = syntheticCells(n);
  BondTable bonds;
  bonds.resize(n);
  double sum = 0, squares = 0;
  Index done = 0;
  CycleReport report;
  for (int k = 1; done < n; ++k) {
    const auto mothers = cycle.advance(agents, rules, report);
    division.divide(agents, bonds, mothers);
    for (const Index mother : mothers) {
      if (agents.generation[mother] != generations) continue;
      const double hours = (k * step - agents.clock[mother]) / hour;
      sum += hours, squares += hours * hours;
      ++done;
    }
    // Lines of mothers only, so that times are independent.
    std::vector<std::uint8_t> born(agents.size(), 0);
    std::fill(born.begin() + n, born.end(), std::uint8_t{1});
    agents.erase(born);
    bonds.erase(born);
    bonds.resize(n);
    ASSERT_LT(k, 1000);
  }
  const double mean = sum / n;
  const double variance = squares / n - mean * mean;
  EXPECT_NEAR(mean, generations * 32.0, 5 * std::sqrt(generations * 4.0 / n));
  // Four independent truncated normal lengths of G1; a mere S/G2/M in between adds none.
  EXPECT_NEAR(variance, generations * 4 * 0.97334, 5 * generations * 4 * std::sqrt(2.0 / n));
}

INSTANTIATE_TEST_SUITE_P(Hours, CellCycleStep, ::testing::Values(0.25, 1.0, 7.0, 24.0));

TEST_P(CellCycleStep, PopulationDoublesEveryCycleExactly) {
  const double step = GetParam();
  CellCycleParameters parameters;
  parameters.g1Mean = 16.3 * hour;
  parameters.g1Spread = 0;
  parameters.sg2mDuration = 15.4 * hour;
  const CellCycle cycle(parameters, 1, step * hour);
  const Division division(1, 0.4);
  AgentStore agents = syntheticCells(3);
  BondTable bonds;
  bonds.resize(3);
  CycleReport report;
  for (int k = 1; k * step < 300; ++k) {
    division.divide(agents, bonds, cycle.advance(agents, rules, report));
    EXPECT_EQ(agents.size(), 3u << static_cast<int>(std::floor(k * step / 31.7 + 1e-9)))
        << "hour " << k * step;
  }
}

TEST(DivisionDirection, IsUniformOnTheSphere) {
  const Index n = 20000;
  AgentStore agents = syntheticCells(n);
  BondTable bonds;
  bonds.resize(n);
  std::vector<Index> all(n);
  std::vector<Vec3> centre(n);
  for (Index i = 0; i < n; ++i) all[i] = i, centre[i] = agents.position(i);
  Division(1, 0.4).divide(agents, bonds, all);

  // Five slices of equal height have equal area; four quarters each.
  std::map<int, int> bins;
  for (Index i = 0; i < n; ++i) {
    const Vec3 d = (agents.position(i) - centre[i]).normalized();
    const int slice = std::min(4, static_cast<int>((d.z() + 1) * 2.5));
    ++bins[4 * slice + (d.x() > 0) + 2 * (d.y() > 0)];
  }
  ASSERT_EQ(bins.size(), 20u);
  double chiSquare = 0;
  for (const auto& [bin, count] : bins) chiSquare += std::pow(count - n / 20.0, 2) / (n / 20.0);
  // 0.01 % and 99.99 % of chi-square with 19 degrees of freedom.
  EXPECT_GT(chiSquare, 4.0);
  EXPECT_LT(chiSquare, 50.8);
}

}  // namespace
}  // namespace restenosis
