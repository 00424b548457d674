#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/CellCycles.h"
#include "tissue/biology/Biology.h"

namespace restenosis {
namespace {

using support::phases;

/// Cells in free space after some steps, with nothing to hold them back.
AgentStore grow(const CellCycleParameters& parameters, double step, int steps) {
  BiologySettings settings;
  settings.cellCycle = parameters;
  settings.step = step;
  const Biology biology(settings);
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3::Zero(), 15e-6);
  agents.set(0, synthetic, true);
  BondTable bonds;
  bonds.resize(1);
  for (int k = 0; k < steps; ++k) {
    biology.advanceCycle(agents, bonds);
    for (Index i = 0; i < agents.size(); ++i) {
      EXPECT_TRUE(std::isfinite(agents.radius[i]) && std::isfinite(agents.clock[i]));
      EXPECT_LE(agents.radius[i], 15e-6 * std::cbrt(2.0));
      const double limit = agents.state[i] == CycleState::g0   ? step
                           : agents.state[i] == CycleState::g1 ? agents.g1Duration[i]
                                                               : parameters.sg2mDuration;
      EXPECT_LE(agents.clock[i], limit);
    }
  }
  return agents;
}

TEST(CellCycleExtremes, PhasesOfNoLengthDivideOnceAStep) {
  EXPECT_EQ(grow(phases(0, 0), 3600, 10).size(), 1024u);
  EXPECT_EQ(grow(phases(0, 0), 86400, 10).size(), 1024u);
}

TEST(CellCycleExtremes, OnePhaseOfNoLength) {
  EXPECT_EQ(grow(phases(0, 7200), 3600, 10).size(), 32u);
  EXPECT_EQ(grow(phases(7200, 0), 3600, 10).size(), 32u);
}

TEST(CellCycleExtremes, AStepOfADay) { EXPECT_EQ(grow(phases(16 * 3600, 16 * 3600), 86400, 8).size(), 64u); }

/// Cells after `time`, of one that begins its cycle now: followed through its pedigree in time, not in steps.
std::size_t cellsAfter(double time, const CellCycle& cycle, double sg2m, AgentId id,
                       std::uint32_t generation = 0) {
  time -= cycle.drawG1Duration(id, generation) + sg2m;
  if (time < 0) return 1;
  return cellsAfter(time, cycle, sg2m, id, generation + 1) +
         cellsAfter(time, cycle, sg2m, daughterId(id, generation + 1), generation + 1);
}

TEST(CellCycleExtremes, ASpreadWiderThanTheMeanNeverGivesANegativeLength) {
  CellCycleParameters parameters = phases(3600, 3600);
  parameters.g1Spread = 100 * 3600;
  const CellCycle cycle(parameters, BiologySettings().seed, 3600);
  for (AgentId id = 0; id < 1000; ++id) EXPECT_GE(cycle.drawG1Duration(id, 0), 0);
  const std::size_t cells = grow(parameters, 3600, 40).size();
  EXPECT_GT(cells, 1u);
  EXPECT_EQ(cells, cellsAfter(40 * 3600, cycle, parameters.sg2mDuration, 0));
}

}  // namespace
}  // namespace restenosis
