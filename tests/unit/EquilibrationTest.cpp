#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/support/Constants.h"
#include "tests/support/Mechanics.h"
#include "tissue/equilibrium/Equilibration.h"

namespace restenosis {
namespace {

using namespace support;

/// Two agents held apart by a fixed one on either side, in a line.
struct Line {
  AgentStore agents;
  BondTable bonds;
  Mechanics settings;
  ForceField field{settings.forces};
  NeighbourList neighbours;

  explicit Line(Index count) {
    for (Index i = 0; i < count; ++i) {
      agents.append(AgentKind::smc, Vec3(1.9 * r * i, 0, 0), r);
      agents.set(i, AgentFlag::fixed, i == 0 || i + 1 == count);
    }
    bonds.resize(count);
  }
  Equilibration equilibration() {
    const ForceCache::Settings cache{.leastStiffness = 1e-3, .skin = 0.4 * r, .mixed = FixedScale(r)};
    return {agents, bonds, {}, field, neighbours, cache, settings.relaxation};
  }
};

TEST(Equilibration, CentresAnAgentBetweenTwoOthers) {
  Line line(3);
  line.agents.x[1] += 0.03 * r;
  Equilibration equilibration = line.equilibration();
  const RelaxationReport report = equilibration.run({});
  EXPECT_TRUE(report.converged);
  EXPECT_GT(report.iterations, 0);
  EXPECT_NEAR(line.agents.x[1] / r, 1.9, 0.1 * line.settings.relaxation.tolerance);
  EXPECT_EQ(report.residual <= 0.1 * line.settings.relaxation.tolerance, true) << report.residual;
}

TEST(Equilibration, GoesOnWithoutEvaluatingWhatHasNotChanged) {
  Line line(1000);
  Equilibration equilibration = line.equilibration();
  const RelaxationReport first = equilibration.run({});
  EXPECT_EQ(first.iterations, 0);
  EXPECT_EQ(first.agentEvaluations, 1000U);
  EXPECT_EQ(equilibration.run({}).agentEvaluations, 0U);
  line.agents.x[500] += 0.0001 * r;
  const RelaxationReport moved = equilibration.run({});
  EXPECT_EQ(moved.iterations, 0) << "less than the tolerance";
  EXPECT_EQ(moved.agentEvaluations, 3U);
  line.agents.x[500] += 0.05 * r;
  const RelaxationReport disturbed = equilibration.run({});
  EXPECT_TRUE(disturbed.converged);
  EXPECT_LT(disturbed.agentEvaluations, 100U * static_cast<unsigned>(disturbed.iterations));
}

TEST(Equilibration, EndsWhereTheCallbackThrows) {
  Line line(3);
  line.agents.x[1] += 0.05 * r;
  Equilibration equilibration = line.equilibration();
  int calls = 0;
  EXPECT_THROW(equilibration.run([&] {
    if (++calls == 3) throw std::runtime_error("enough");
  }),
               std::runtime_error);
  EXPECT_EQ(calls, 3);
}

TEST(Equilibration, NamesTheWorstAgentWhereItDidNotConverge) {
  Line line(40);
  line.settings.relaxation.maximumIterations = 1;
  line.agents.x[20] += 0.1 * r;
  Equilibration equilibration = line.equilibration();
  EXPECT_FALSE(equilibration.run({}).converged);
  EXPECT_NEAR(equilibration.worstAgent(), 20, 1);
}

}  // namespace
}  // namespace restenosis
