#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tissue/biology/Endothelium.h"

namespace restenosis {
namespace {

constexpr double day = 86400;

AgentStore exposedCells(Index n) {
  AgentStore agents;
  for (Index i = 0; i < n; ++i) {
    agents.append(AgentKind::smc, Vec3(0, 0, 1e-5 * i), 15e-6);
    agents.set(i, exposed, true);
    agents.set(i, synthetic, true);
  }
  return agents;
}

TEST(Endothelium, CoversTheScenariosShare) {
  AgentStore agents = exposedCells(1000);
  const Endothelium endothelium({}, 1, true);
  EXPECT_EQ(endothelium.apply(agents, 2.9 * day).covered, 0u);
  EXPECT_EQ(endothelium.apply(agents, 3 * day).covered, 590u);
  EXPECT_EQ(endothelium.apply(agents, 13 * day).covered, 795u);
  EXPECT_EQ(endothelium.apply(agents, 13 * day).newlyCovered, 0u);
  EXPECT_EQ(endothelium.apply(agents, 23 * day).covered, 1000u);
}

TEST(Endothelium, CoversOnlyExposedSyntheticSmc) {
  AgentStore agents = exposedCells(4);
  agents.set(0, exposed, false);
  agents.set(1, synthetic, false);
  agents.kind[2] = AgentKind::iel;
  Endothelium({}, 1, true).apply(agents, 30 * day);
  EXPECT_FALSE(agents.has(0, covered));
  EXPECT_FALSE(agents.has(1, covered));
  EXPECT_FALSE(agents.has(2, covered));
  EXPECT_TRUE(agents.has(3, covered));
}

TEST(Endothelium, CoversTheSameCellsInAnyOrder) {
  AgentStore agents = exposedCells(500);
  AgentStore reversed = agents;
  std::vector<Index> order(500);
  for (Index k = 0; k < 500; ++k) order[k] = 499 - k;
  reversed.reorder(order);
  const Endothelium endothelium({}, 3, true);
  endothelium.apply(agents, 5 * day);
  endothelium.apply(reversed, 5 * day);
  for (Index i = 0; i < 500; ++i) EXPECT_EQ(agents.flags[i], reversed.flags[499 - i]);
}

TEST(Endothelium, DependsOnTheSeed) {
  AgentStore one = exposedCells(100), other = exposedCells(100);
  Endothelium({}, 1, true).apply(one, 5 * day);
  Endothelium({}, 2, true).apply(other, 5 * day);
  EXPECT_NE(one.flags, other.flags);
}

TEST(Endothelium, NeverLosesCoverageWhileFewerCellsAreExposed) {
  AgentStore agents = exposedCells(100);
  const Endothelium endothelium({}, 1, true);
  endothelium.apply(agents, 3 * day);
  const auto before = agents.flags;
  for (Index i = 0; i < 100; i += 2) agents.set(i, exposed, false);
  endothelium.apply(agents, 3 * day);
  for (Index i = 0; i < 100; ++i) {
    EXPECT_GE(agents.flags[i] & covered, before[i] & covered);
  }
}

TEST(Endothelium, CoversAllFromTheStartWithoutDenudation) {
  AgentStore agents = exposedCells(10);
  const Endothelium endothelium({}, 1, false);
  EXPECT_EQ(endothelium.onset(), 0.0);
  EXPECT_EQ(endothelium.apply(agents, 0).covered, 10u);
}

TEST(Endothelium, KnowsWhenItSetsIn) { EXPECT_EQ(Endothelium({}, 1, true).onset(), 3 * day); }

TEST(Endothelium, MaturesByItsAge) {
  EndotheliumParameters parameters;
  parameters.maturationTime = 10 * day;
  AgentStore agents = exposedCells(1000);
  agents.maturity.model(agents.size());
  const Endothelium endothelium(parameters, 1, true);
  const int hours = 20 * 24;
  std::vector<double> age(agents.size(), 0.0);
  for (int n = 0; n < hours; ++n) {
    endothelium.apply(agents, 3600.0 * n);
    endothelium.mature(agents, 3600);
    for (Index i = 0; i < agents.size(); ++i) age[i] += agents.has(i, covered) ? 3600 : 0;
  }
  for (Index i = 0; i < agents.size(); ++i)
    EXPECT_NEAR(agents.maturity[i], -std::expm1(-age[i] / parameters.maturationTime), 1e-5) << i;
}

TEST(Endothelium, IsMatureWhereDeploymentLeftIt) {
  EndotheliumParameters parameters;
  parameters.maturationTime = 10 * day;
  AgentStore agents = exposedCells(2);
  agents.maturity.model(agents.size());
  agents.set(0, covered, true);
  const Endothelium endothelium(parameters, 1, false);
  endothelium.begin(agents);
  EXPECT_EQ(agents.maturity[0], 1);
  EXPECT_EQ(agents.maturity[1], 0);
  endothelium.apply(agents, 0);  // the rest of it grows over what becomes exposed
  EXPECT_EQ(agents.maturity[1], 1);
}

}  // namespace
}  // namespace restenosis
