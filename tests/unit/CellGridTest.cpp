#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/CellGrid.h"

namespace restenosis {
namespace {

AgentStore scattered(int count, double side, double radius = 1e-5) {
  AgentStore agents;
  RandomStream random(3, 0, 0, RandomPurpose::packing);
  for (int k = 0; k < count; ++k) {
    agents.append(AgentKind::smc, side * Vec3(random.uniform() - 0.5, random.uniform(), random.uniform()),
                  radius);
  }
  return agents;
}

/// Every agent within `distance` of every agent is a candidate, and none twice.
void expectComplete(const AgentStore& agents, const CellGrid& grid, double distance) {
  for (Index i = 0; i < agents.size(); ++i) {
    std::multiset<Index> candidates;
    grid.forEachCandidate(agents.position(i), distance, [&](Index j) { candidates.insert(j); });
    for (Index j = 0; j < agents.size(); ++j) {
      ASSERT_LE(candidates.count(j), 1u);
      if ((agents.position(i) - agents.position(j)).norm() <= distance) {
        ASSERT_EQ(candidates.count(j), 1u) << i << ' ' << j;
      }
    }
  }
}

TEST(CellGrid, MissesNobodyAndRepeatsNobody) {
  const AgentStore agents = scattered(300, 2e-4);
  for (const double cell : {1e-5, 3e-5, 1e-3}) {
    const CellGrid grid(agents, cell);
    for (const double distance : {0.5e-5, 3e-5, 1e-4}) expectComplete(agents, grid, distance);
  }
}

TEST(CellGrid, StaysSmallWhenAgentsAreFarAway) {
  AgentStore agents = scattered(200, 2e-4);
  const double last[] = {1.0, -1e6, 1e200};
  for (const double x : last) agents.append(AgentKind::smc, {x, -x, x}, 1e-5);
  agents.append(AgentKind::smc, {1.0 + 1e-5, -1.0, 1.0}, 1e-5);
  const CellGrid grid(agents, 3e-5);
  EXPECT_LT(grid.cellCount(), 4096 + 8 * agents.size() + 1);
  expectComplete(agents, grid, 3e-5);
}

TEST(CellGrid, TakesNoAgents) {
  int found = 0;
  CellGrid(AgentStore{}, 1e-5).forEachCandidate({0, 0, 0}, 1.0, [&](Index) { ++found; });
  EXPECT_EQ(found, 0);
}

TEST(CellGrid, NamesTheAgentWithoutAPosition) {
  AgentStore agents = scattered(10, 1e-4);
  agents.z[7] = HUGE_VAL;
  try {
    CellGrid(agents, 1e-5);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("agent 7"), std::string::npos) << e.what();
  }
  EXPECT_THROW(CellGrid(scattered(3, 1e-4), 0), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
