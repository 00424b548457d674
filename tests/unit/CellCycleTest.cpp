#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/CellCycles.h"
#include "tests/support/Constants.h"
#include "tissue/biology/CellCycle.h"

namespace restenosis {
namespace {

using namespace support;

const double fullRadius = r * std::cbrt(2.0);

BiologySettings underEndothelium() {
  BiologySettings settings;
  settings.endothelium.emplace();
  return settings;
}

const ArrestRules rules(underEndothelium());

AgentStore oneCell() {
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3::Zero(), r);
  agents.set(0, synthetic, true);
  return agents;
}

TEST(CellCycle, DrawsG1WithMeanSpreadAndTruncation) {
  const CellCycle cycle({}, 1, hour);
  const int n = 20000;
  double sum = 0, squares = 0;
  for (int id = 0; id < n; ++id) {
    const double hours = cycle.drawG1Duration(id, 0) / hour;
    EXPECT_GE(hours, 10);
    EXPECT_LE(hours, 22);
    sum += hours, squares += (hours - 16) * (hours - 16);
  }
  // Variance of a normal truncated at 3 sigma: 1 - 2 * 3 phi(3) / (2 Phi(3) - 1) = 0.97334.
  EXPECT_NEAR(sum / n, 16, 5 * 2 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 4 * 0.97334, 5 * 4 * std::sqrt(2.0 / n));
  EXPECT_EQ(cycle.drawG1Duration(5, 3), cycle.drawG1Duration(5, 3));
  EXPECT_NE(cycle.drawG1Duration(5, 3), cycle.drawG1Duration(5, 4));
  EXPECT_NE(cycle.drawG1Duration(5, 3), cycle.drawG1Duration(6, 3));
}

TEST(CellCycle, RecruitsCellsOneAfterAnother) {
  CellCycleParameters parameters = phases(16 * hour, 16 * hour);
  parameters.recruitment = 20 * hour;
  const CellCycle cycle(parameters, 1, hour);
  AgentStore agents;
  const Index cells = 4000, divided = cells;
  for (Index i = 0; i <= cells; ++i) {
    agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.set(i, synthetic, true);
  }
  agents.generation[divided] = 1;
  for (int step = 0; step < 20; ++step) {
    CycleReport report;
    cycle.advance(agents, rules, report, step * hour);
    // Four standard deviations of a binomial with probability 1/20; daughters need no recruitment.
    EXPECT_NEAR(report.enteredG1, cells / 20 + (step == 0), 4 * std::sqrt(cells / 20.0));
  }
  for (Index i = 0; i < cells; ++i) {
    const double recruited = cycle.drawRecruitment(agents.id[i]);
    EXPECT_GE(recruited, 0.0);
    EXPECT_LT(recruited, 20 * hour);
    if (agents.state[i] == CycleState::g1) {
      EXPECT_NEAR(agents.clock[i], 20 * hour - recruited, 1e-6);  // to the second, not to the step
    }
  }
}

TEST(CellCycle, GrowsExponentiallyToTwiceTheVolume) {
  const CellCycle cycle(phases(16 * hour, 16 * hour), 1, hour);
  AgentStore agents = oneCell();
  CycleReport report;
  for (int step = 1; step <= 32; ++step) {
    const auto dividing = cycle.advance(agents, rules, report);
    EXPECT_NEAR(agents.radius[0], r * std::exp2(std::min(step, 16) / 48.0), 1e-18) << step;
    EXPECT_EQ(agents.state[0], step < 16 ? CycleState::g1 : CycleState::sg2m) << step;
    EXPECT_EQ(dividing.size(), step == 32 ? 1u : 0u) << step;
  }
  EXPECT_EQ(agents.radius[0], fullRadius);
  EXPECT_EQ(report.enteredG1, 1u);
  EXPECT_EQ(report.enteredSg2m, 1u);
  EXPECT_EQ(report.arrested, 0u);
}

TEST(CellCycle, RestsWhereARuleForbidsIt) {
  const CellCycle cycle({}, 1, hour);
  const auto rests = [&](auto change) {
    AgentStore agents = oneCell();
    change(agents);
    CycleReport report;
    cycle.advance(agents, rules, report);
    return agents.state[0] == CycleState::g0 && agents.radius[0] == r && report.enteredG1 == 0;
  };
  EXPECT_FALSE(rests([](AgentStore&) {}));
  EXPECT_FALSE(rests([](AgentStore& a) { a.nitricOxide[0] = 0.000999; }));
  EXPECT_TRUE(rests([](AgentStore& a) { a.nitricOxide[0] = 0.001; }));
  EXPECT_TRUE(rests([](AgentStore& a) { a.set(0, inhibited, true); }));
  EXPECT_TRUE(rests([](AgentStore& a) { a.set(0, synthetic, false); }));
  EXPECT_TRUE(rests([](AgentStore& a) { a.set(0, fixed, true); }));
  EXPECT_TRUE(rests([](AgentStore& a) { a.kind[0] = AgentKind::iel; }));
}

TEST(CellCycle, KeepsTheRadiusOfACellSentBackAndNeverInflatesIt) {
  const CellCycle cycle(phases(16 * hour, 16 * hour), 1, hour);
  AgentStore agents = oneCell();
  CycleReport report;
  for (int round = 0; round < 10; ++round) {
    agents.set(0, inhibited, false);
    for (int step = 0; step < 8; ++step) cycle.advance(agents, rules, report);
    EXPECT_EQ(agents.clock[0], 8 * hour);
    const double grown = agents.radius[0];
    EXPECT_NEAR(grown, std::min(fullRadius, r * std::exp2((round + 1) * 8 / 48.0)), 1e-18);
    agents.set(0, inhibited, true);
    cycle.advance(agents, rules, report);
    EXPECT_EQ(agents.state[0], CycleState::g0);
    EXPECT_EQ(agents.clock[0], 0);
    EXPECT_EQ(agents.radius[0], grown);
  }
  EXPECT_EQ(report.arrested, 10u);
  EXPECT_EQ(agents.radius[0], fullRadius);
}

TEST(CellCycle, FinishesWhatItStartedAfterG1) {
  const CellCycle cycle(phases(2 * hour, 2 * hour), 1, hour);
  AgentStore agents = oneCell();
  CycleReport report;
  cycle.advance(agents, rules, report);
  cycle.advance(agents, rules, report);
  ASSERT_EQ(agents.state[0], CycleState::sg2m);
  agents.set(0, inhibited, true);
  agents.set(0, synthetic, false);
  agents.nitricOxide[0] = 1;
  EXPECT_TRUE(cycle.advance(agents, rules, report).empty());
  EXPECT_EQ(cycle.advance(agents, rules, report).size(), 1u);
}

TEST(CellCycle, CarriesTheRestOfAStepIntoTheNextPhase) {
  const CellCycle cycle(phases(2.25 * hour, 1.5 * hour), 1, hour);
  AgentStore agents = oneCell();
  CycleReport report;
  for (int step = 0; step < 3; ++step) cycle.advance(agents, rules, report);
  EXPECT_EQ(agents.state[0], CycleState::sg2m);
  EXPECT_NEAR(agents.clock[0], 0.75 * hour, 1e-9);
  EXPECT_EQ(cycle.advance(agents, rules, report).size(), 1u);
  EXPECT_NEAR(agents.clock[0], 0.25 * hour, 1e-9);
}

/// Clocks are sums of steps: 23 times 0.7 h is less than 16.1 h by rounding, 7 times more than 4.9 h.
TEST(CellCycle, PhasesThatAreWholeNumbersOfStepsTakeAsMany) {
  for (const double step : {0.1 * hour, 0.3 * hour, 0.7 * hour, 1.1 * hour}) {
    for (int g1 = 1; g1 <= 60; ++g1) {
      const int sg2m = 61 - g1;
      const CellCycle cycle(phases(g1 * step, sg2m * step), 1, step);
      AgentStore agents = oneCell();
      CycleReport report;
      for (int k = 1; k < g1; ++k) cycle.advance(agents, rules, report);
      EXPECT_NE(agents.state[0], CycleState::sg2m) << g1;
      cycle.advance(agents, rules, report);
      EXPECT_EQ(agents.state[0], CycleState::sg2m) << g1;
      for (int k = 1; k < sg2m; ++k) EXPECT_TRUE(cycle.advance(agents, rules, report).empty()) << g1;
      EXPECT_EQ(cycle.advance(agents, rules, report).size(), 1u) << g1;
      EXPECT_GE(agents.clock[0], 0.0);
      EXPECT_LT(agents.clock[0], 1e-6 * step);
    }
  }
}

TEST(CellCycle, LosesTheRestWhereTheNextCheckpointHoldsTheCell) {
  const CellCycle cycle(phases(16 * hour, 16 * hour), 1, hour);
  AgentStore agents = oneCell();
  agents.clock[0] = 0.5 * hour;
  agents.set(0, inhibited, true);
  CycleReport report;
  cycle.advance(agents, rules, report);
  EXPECT_EQ(agents.clock[0], 0);
}

TEST(CellCycle, ReturnsDividingCellsInTheOrderOfTheirIds) {
  const CellCycle cycle(phases(0, 0), 1, hour);
  AgentStore agents;
  for (int n = 0; n < 3; ++n) {
    agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.set(n, synthetic, true);
  }
  agents.reorder(std::vector<Index>{2, 0, 1});
  CycleReport report;
  EXPECT_EQ(cycle.advance(agents, rules, report), (std::vector<Index>{1, 2, 0}));
}

}  // namespace
}  // namespace restenosis
