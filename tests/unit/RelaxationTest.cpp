#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/Constants.h"
#include "tests/support/Mechanics.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/forces/ForceField.h"

namespace restenosis {
namespace {

using namespace support;

/// A block of agents n across on a disturbed face-centred lattice with overlaps of about 5 % of the diameter,
/// or `layers` high, its lowest and highest layer fixed, bonded where near.
struct Block {
  AgentStore agents;
  BondTable bonds;

  explicit Block(int n, bool bonded = true) : Block(n, bonded, n) {}
  Block(int n, bool bonded, int layers) {
    const double spacing = 1.9 * r / std::sqrt(2.0);
    for (int z = 0; z < layers; ++z) {
      for (int y = 0; y < n; ++y) {
        for (int x = (y + z) % 2; x < n; x += 2) {
          RandomStream random(1, agents.nextId, 0, RandomPurpose::packing);
          const Vec3 noise = 0.1 * r * random.uniform() * random.direction();
          const Index i = agents.append(AgentKind::smc, Vec3(x, y, z) * spacing + noise, r);
          agents.set(i, AgentFlag::fixed, z == 0 || z == layers - 1);
        }
      }
    }
    bonds.resize(agents.size());
    for (Index i = 0; bonded && i < agents.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        const double distance = (agents.position(i) - agents.position(j)).norm();
        if (distance < 2.2 * r) bonds.connect(i, j, distance);
      }
    }
  }
};

double largestDifference(const AgentStore& a, const AgentStore& b) {
  double largest = 0;
  for (Index i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position(i) - b.position(i)).norm());
  return largest;
}

/// How far the force on each agent would move it, over its radius; 0 for fixed ones. An agent is held as by a
/// contact 2 % of its radius deep at least.
std::vector<double> residuals(const Mechanics& p, const Block& block) {
  std::vector<double> found(block.agents.size());
  const auto loads = ForceField(p.forces).evaluate(block.agents, block.bonds);
  for (Index i = 0; i < block.agents.size(); ++i) {
    if (!block.agents.has(i, AgentFlag::fixed))
      found[i] = loads[i].force().norm() / std::max(loads[i].stiffness, 1.2 * p.forces.contactModulus * r) /
                 block.agents.radius[i];
  }
  return found;
}

double largestResidual(const Mechanics& p, const Block& block) {
  return std::ranges::max(residuals(p, block));
}

std::uint64_t countFree(const AgentStore& agents) {
  return static_cast<std::uint64_t>(std::ranges::count(agents.flags, 0));
}

TEST(Relaxation, LeavesFixedAgentsThePressureOfTheirPlaceToo) {
  for (const auto* precision : {"double", "mixed"}) {
    Mechanics p;
    p.relaxation.precision = precision;
    Block block(7);
    Relaxation relaxation(p.forces, p.relaxation, r);
    const auto expectPressures = [&] {
      relaxation.relaxAgain(block.agents, block.bonds, {});
      const auto loads = ForceField(p.forces).evaluate(block.agents, block.bonds);
      double largest = 0;
      for (const AgentLoad& load : loads) largest = std::max(largest, std::abs(load.stress));
      for (Index i = 0; i < block.agents.size(); ++i)
        ASSERT_NEAR(block.agents.stress[i], loads[i].stress, 1e-5 * largest) << precision << " " << i;
    };
    expectPressures();
    block.agents.radius[block.agents.size() / 10] *= 1.2;
    expectPressures();
  }
}

TEST(Relaxation, LeavesNoForceAboveTheTolerance) {
  for (const auto* law : {"hertz", "hertzNeoHookean"}) {
    for (const auto* minimiser : {"fire", "overdamped"}) {
      Mechanics p;
      p.forces.contactLaw = law, p.relaxation.minimiser = minimiser;
      Block block(7);
      const auto report = Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
      EXPECT_TRUE(report.converged);
      EXPECT_GT(report.iterations, 0);
      EXPECT_LE(report.residual, p.relaxation.tolerance);
      EXPECT_NEAR(report.residual / largestResidual(p, block), 1, 1e-4) << law << ' ' << minimiser;
    }
  }
}

TEST(Relaxation, MovesNeitherFixedAgentsNorStruts) {
  Block block(5);
  block.agents.kind[30] = AgentKind::strut;
  const AgentStore before = block.agents;
  Relaxation({}, {}, r).relax(block.agents, block.bonds, {});
  for (Index i = 0; i < before.size(); ++i) {
    const bool obstacle = before.has(i, AgentFlag::fixed) || i == 30;
    if (obstacle) {
      EXPECT_EQ(block.agents.position(i), before.position(i));
    }
  }
  EXPECT_GT(largestDifference(block.agents, before), 0);
}

TEST(Relaxation, GivesTheSameBitsForAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  Block one(18), three(18);  // enough agents that the loops run in parallel
  omp_set_num_threads(1);
  Relaxation({}, {}, r).relax(one.agents, one.bonds, {});
  omp_set_num_threads(3);
  Relaxation({}, {}, r).relax(three.agents, three.bonds, {});
  omp_set_num_threads(threads);
  EXPECT_EQ(one.agents.x, three.agents.x);
  EXPECT_EQ(one.agents.y, three.agents.y);
  EXPECT_EQ(one.agents.z, three.agents.z);
  EXPECT_EQ(one.agents.stress, three.agents.stress);
}

TEST(Relaxation, DoesNotDependOnWhatWasRelaxedBefore) {
  // A run that is resumed begins with no neighbour list; its results must be those of the one that went on.
  for (const auto* precision : {"mixed", "double"}) {
    Mechanics p;
    p.relaxation.precision = precision;
    Block block(13);
    Relaxation relaxation(p.forces, p.relaxation, r);
    relaxation.relax(block.agents, block.bonds, {});
    for (int poke = 0; poke < 8; ++poke) {
      for (Index i = 300 + static_cast<Index>(poke); i < block.agents.size(); i += 400)
        block.agents.radius[i] *= 1.04;
      Block fresh = block;
      relaxation.relax(block.agents, block.bonds, {});
      Relaxation(p.forces, p.relaxation, r).relax(fresh.agents, fresh.bonds, {});
      EXPECT_EQ(largestDifference(block.agents, fresh.agents), 0) << precision << ", poke " << poke;
    }
  }
}

/// Keeps agents above the plane z = 0.5 r.
struct Floor : Constraint {
  explicit Floor(bool tells = true) : tellsMargin(tells) {}
  bool tellsMargin;
  double margin(AgentKind, double, const Vec3& position) const override {
    return tellsMargin ? position.z() - 0.5 * r : 0;
  }
  void project(AgentKind, double, Vec3& position) const override {
    position.z() = std::max(position.z(), 0.5 * r);
  }
  void release(AgentKind, double, const Vec3& position, Vec3& force) const override {
    if (position.z() <= 0.5 * r && force.z() < 0) force.z() = 0;
  }
};

TEST(Relaxation, AgainIsTheSameAsAnew) {
  const Floor floor;
  const std::array<const Constraint*, 1> constraints{&floor};
  for (const auto* precision : {"mixed", "double"}) {
    Mechanics p;
    p.relaxation.precision = precision;
    Block block(11);
    Relaxation relaxation(p.forces, p.relaxation, r);
    relaxation.relaxAgain(block.agents, block.bonds, constraints);
    std::uint64_t again = 0, anew = 0;
    for (int step = 0; step < 12; ++step) {
      AgentStore& agents = block.agents;
      agents.radius[250 + step] *= 1.1;
      for (int n = 0; n < 1 + 20 * (step % 3); ++n) {  // a division
        const Index mother = 200 + static_cast<Index>(7 * step + 31 * n) % 400;
        const Vec3 offset = 0.3 * r * RandomStream(4, step, n, RandomPurpose::packing).direction();
        const Index born = agents.append(AgentKind::smc, agents.position(mother) - offset, 0.8 * r);
        agents.set(born, AgentFlag::daughter, true);
        agents.setPosition(mother, agents.position(mother) + offset);
      }
      block.bonds.resize(agents.size());
      if (step == 7) {
        std::vector<Index> order(agents.size());
        for (Index k = 0; k < order.size(); ++k) order[k] = (k * 7 + 3) % agents.size();
        ASSERT_NE(agents.size() % 7, 0u);
        agents.reorder(order);
        block.bonds.reorder(order);
      }
      Block fresh = block;
      again += relaxation.relaxAgain(agents, block.bonds, constraints).agentEvaluations;
      anew += Relaxation(p.forces, p.relaxation, r)
                  .relax(fresh.agents, fresh.bonds, constraints)
                  .agentEvaluations;
      ASSERT_EQ(largestDifference(agents, fresh.agents), 0) << precision << ", step " << step;
      ASSERT_EQ(agents.stress, fresh.agents.stress) << precision << ", step " << step;
    }
    EXPECT_LT(again, anew);
  }
}

TEST(Relaxation, AMarginThatAConstraintTellsChangesNothing) {
  const Floor telling, silent(false);
  for (const auto* minimiser : {"fire", "overdamped"}) {
    Mechanics p;
    p.relaxation.minimiser = minimiser;
    p.relaxation.stopAtMaximum = true;
    p.relaxation.maximumIterations = 200;
    Block told(11), asked = told;
    for (Block* block : {&told, &asked}) {
      for (Index i = 0; i < block->agents.size(); ++i) {
        block->agents.set(i, AgentFlag::fixed, false);
        block->agents.setPosition(i,
                                  block->agents.position(i) - Vec3(0, 0, r));  // two layers below the floor
      }
    }
    Relaxation(p.forces, p.relaxation, r)
        .relax(told.agents, told.bonds, std::array<const Constraint*, 1>{&telling});
    Relaxation(p.forces, p.relaxation, r)
        .relax(asked.agents, asked.bonds, std::array<const Constraint*, 1>{&silent});
    EXPECT_EQ(largestDifference(told.agents, asked.agents), 0) << minimiser;
    EXPECT_EQ(std::ranges::min(told.agents.z), 0.5 * r) << "some lie on the floor";
  }
}

TEST(Relaxation, LeavesAQuietTissueAsItIs) {
  Block block(6);
  Relaxation relaxation({}, {}, r);
  relaxation.relax(block.agents, block.bonds, {});
  const AgentStore before = block.agents;
  const auto report = relaxation.relax(block.agents, block.bonds, {});
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(before.x, block.agents.x);
}

TEST(Relaxation, WorksWhereSomethingGrows) {
  Mechanics p;
  Block block(12);
  Relaxation relaxation(p.forces, p.relaxation, r);
  relaxation.relax(block.agents, block.bonds, {});
  const Index grown = block.agents.size() / 2 + 3;
  block.agents.radius[grown] *= 1.05;
  const auto report = relaxation.relax(block.agents, block.bonds, {});
  EXPECT_LE(largestResidual(p, block), p.relaxation.tolerance);
  // One evaluation of all to see which are above the tolerance; the rest near the grown cell only.
  const std::uint64_t everyoneOnce = countFree(block.agents);
  ASSERT_GT(report.iterations, 5);
  EXPECT_LT(report.agentEvaluations - everyoneOnce, 0.2 * report.iterations * everyoneOnce);
}

/// One agent between two fixed ones, each overlapping it by `overlap` radii, and moved off the middle until
/// the force on it would move it by this share of its radius.
Block heldAgent(const Mechanics& p, double overlap, double residual) {
  Block row(0);
  for (int k = -1; k <= 1; ++k) {
    const Index i = row.agents.append(AgentKind::smc, Vec3(k * (2 - overlap) * r, 0, 0), r);
    row.agents.set(i, AgentFlag::fixed, k != 0);
  }
  row.bonds.resize(3);
  while (largestResidual(p, row) < residual) row.agents.x[1] += 1e-6 * r;
  return row;
}

TEST(Relaxation, BringsAgentsAsNearToTheirPlaceHoweverStifflyTheyAreHeld) {
  const Mechanics p;
  const double tolerance = p.relaxation.tolerance;
  for (const double overlap : {0.02, 0.1, 0.5}) {
    Block within = heldAgent(p, overlap, 0.9 * tolerance), beyond = heldAgent(p, overlap, 1.1 * tolerance);
    const AgentStore before = within.agents;
    EXPECT_LT(std::abs(before.x[1]), 2 * tolerance * r) << "contacts are stiffer the deeper they are";
    Relaxation(p.forces, p.relaxation, r).relax(within.agents, within.bonds, {});
    EXPECT_EQ(within.agents.x, before.x) << overlap;
    Relaxation(p.forces, p.relaxation, r).relax(beyond.agents, beyond.bonds, {});
    EXPECT_LE(largestResidual(p, beyond), 0.1 * tolerance) << overlap;
    EXPECT_LT(std::abs(beyond.agents.x[1]), 0.2 * tolerance * r) << overlap;
  }
}

TEST(Relaxation, BringsADaughterWithoutContactToRest) {
  Mechanics p;
  Block block(8, false);
  block.agents.set(block.agents.size() / 2, AgentFlag::daughter, true);
  block.agents.radius[block.agents.size() / 2] *= 0.5;
  EXPECT_TRUE(Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {}).converged);
  EXPECT_LE(largestResidual(p, block), p.relaxation.tolerance);
}

TEST(Relaxation, LeavesThoseThatMovedFarBelowTheTolerance) {
  Mechanics p;
  p.relaxation.tolerance = 2.5e-4;
  Block block(16);
  Relaxation relaxation(p.forces, p.relaxation, r);
  relaxation.relax(block.agents, block.bonds, {});
  block.agents.radius[block.agents.size() / 2 + 3] *= 1.1;
  const AgentStore before = block.agents;
  relaxation.relax(block.agents, block.bonds, {});
  std::vector<double> left;
  const std::vector<double> all = residuals(p, block);
  for (Index i = 0; i < before.size(); ++i) {
    if (before.position(i) != block.agents.position(i)) left.push_back(all[i]);
  }
  ASSERT_GT(left.size(), 20);
  ASSERT_LT(left.size(), before.size() / 4);
  std::ranges::nth_element(left, left.begin() + left.size() / 2);
  EXPECT_LT(left[left.size() / 2], 0.2 * p.relaxation.tolerance);
}

TEST(Relaxation, MovesAllAgentsWithoutAnActiveSet) {
  Mechanics p;
  Block block(12);
  Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
  p.relaxation.activeSet = false;
  Relaxation all(p.forces, p.relaxation, r);
  const AgentStore atRest = block.agents;
  EXPECT_EQ(all.relax(block.agents, block.bonds, {}).iterations, 0) << "none is above the tolerance";
  EXPECT_EQ(atRest.x, block.agents.x);
  block.agents.radius[block.agents.size() / 2 + 3] *= 1.1;
  const auto report = all.relax(block.agents, block.bonds, {});
  ASSERT_GT(report.iterations, 5);
  EXPECT_GE(report.agentEvaluations, static_cast<std::uint64_t>(report.iterations) * countFree(block.agents));
  EXPECT_LE(largestResidual(p, block), p.relaxation.tolerance);
}

TEST(Relaxation, DeactivatesThoseAtRestWhileAFewStillMove) {
  // All of a long column is disturbed a little, one agent much.
  Mechanics p;
  Block column(10, true, 200);
  column.agents.radius[column.agents.size() / 2] *= 4;
  const auto report = Relaxation(p.forces, p.relaxation, r).relax(column.agents, column.bonds, {});
  EXPECT_LE(largestResidual(p, column), p.relaxation.tolerance);
  const std::uint64_t everyone = countFree(column.agents);
  ASSERT_GT(report.iterations, 50);
  EXPECT_LT(report.agentEvaluations, 0.8 * report.iterations * everyone)
      << report.iterations << " iterations";
}

TEST(Relaxation, HasConvergedWhereTheIterationsLeadToTheToleranceOnly) {
  Mechanics p;
  p.relaxation.stopAtMaximum = true;
  p.relaxation.maximumIterations = 1;
  const auto relaxed = [&p] {
    Block block(7);
    return Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
  };
  while (relaxed().residual > p.relaxation.tolerance) ++p.relaxation.maximumIterations;
  const RelaxationReport report = relaxed();
  EXPECT_EQ(report.iterations, p.relaxation.maximumIterations);
  EXPECT_GT(report.residual, 0.1 * p.relaxation.tolerance) << "less than a relaxation aims at";
  p.relaxation.stopAtMaximum = false;
  EXPECT_TRUE(relaxed().converged);
}

TEST(Relaxation, NamesTheSettingsWhenItFails) {
  Mechanics p;
  p.relaxation.maximumIterations = 2;
  Block block(5);
  try {
    Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
    FAIL();
  } catch (const RelaxationFailed& e) {
    EXPECT_NE(std::string(e.what()).find("relaxation.maximumIterations = 2"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("relaxation.tolerance = 0.001"), std::string::npos) << e.what();
    EXPECT_GT(e.report.residual, 0.001);
  }
  p.relaxation.stepLimit = 1e-5;
  try {
    Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
    FAIL();
  } catch (const RelaxationFailed& e) {
    EXPECT_NE(std::string(e.what()).find("relaxation.stepLimit = 1e-05 no agent moves by more than 2e-05"),
              std::string::npos)
        << e.what();
  }
  p = Mechanics();
  p.relaxation.maximumIterations = 2;
  p.relaxation.stopAtMaximum = true;
  Block again(5);
  const auto report = Relaxation(p.forces, p.relaxation, r).relax(again.agents, again.bonds, {});
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_NEAR(report.residual / largestResidual(p, again), 1, 1e-4);
}

TEST(Relaxation, NamesTheAgentWithoutAPosition) {
  Block block(3);
  block.agents.y[5] = std::nan("");
  try {
    Relaxation({}, {}, r).relax(block.agents, block.bonds, {});
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("agent 5"), std::string::npos) << e.what();
  }
}

TEST(Relaxation, RefusesUnknownNames) {
  Mechanics p;
  p.relaxation.minimiser = "steepest";
  EXPECT_THROW(Relaxation(p.forces, p.relaxation, r), std::invalid_argument);
  p = {};
  p.forces.contactLaw = "linear";
  EXPECT_THROW(Relaxation(p.forces, p.relaxation, r), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
