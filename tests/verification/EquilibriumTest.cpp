// Relaxations whose end is known in closed form, and ways to one equilibrium that must agree.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/Constants.h"
#include "tests/support/Mechanics.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/equilibrium/Minimiser.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/forces/ContactLaws.h"
#include "tissue/forces/ForceField.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"

namespace restenosis {
namespace {

using namespace support;

Mechanics with(std::string_view law, std::string_view minimiser, double tolerance) {
  Mechanics p;
  p.forces.contactLaw = law, p.relaxation.minimiser = minimiser, p.relaxation.tolerance = tolerance;
  p.relaxation.maximumIterations = 200000;
  return p;
}

double lawForce(std::string_view law, const Mechanics& p, double overlap) {
  return law == HertzContact::name ? forceOf(HertzContact(p.forces.contactModulus), overlap, r / 2)
                                   : forceOf(HertzNeoHookeanContact(p.forces.contactModulus), overlap, r / 2);
}

/// The root of a falling function.
template <class F>
double bisect(F&& f, double low, double high) {
  for (int k = 0; k < 200; ++k) (f((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return low;
}

TEST(Equilibrium, TwoBondedSpheresRestWhereContactBalancesTheBond) {
  for (const auto law : contactLawNames()) {
    for (const auto minimiser : minimiserNames()) {
      const auto p = with(law, minimiser, 1e-7);
      AgentStore agents;
      const Vec3 direction = Vec3(1, 2, 2) / 3, centre(1e-4, 2e-4, 3e-4);
      for (const double side : {-1.0, 1.0})
        agents.append(AgentKind::smc, centre + side * 0.95 * r * direction, r);
      BondTable bonds;
      bonds.resize(2);
      const auto rest = static_cast<double>(static_cast<float>(1.6 * r));
      bonds.connect(0, 1, rest);
      Relaxation(p.forces, p.relaxation, r).relax(agents, bonds, {});
      const double expected = bisect(
          [&](double x) {
            return lawForce(law, p, 2 * r - x) - p.forces.bondModulus * (x - rest) / rest * 4 * r * r;
          },
          1.6 * r, 2 * r);
      const Vec3 apart = agents.position(1) - agents.position(0);
      EXPECT_NEAR(apart.norm() / expected, 1, 1e-6) << law << ' ' << minimiser;
      // Alone in space, so the axial mobility turns the pair; its centre may only move with the sum of
      // forces: not.
      EXPECT_LT(((agents.position(0) + agents.position(1)) / 2 - centre).norm(), 1e-12);
    }
  }
}

TEST(Equilibrium, SpheresPushedTogetherSeparateToTouchingAndAreNotFlungApart) {
  for (const auto minimiser : minimiserNames()) {
    const auto p = with("hertzNeoHookean", minimiser, 1e-7);
    AgentStore agents;
    for (const double side : {-1.0, 1.0}) agents.append(AgentKind::smc, {0, side * 0.4 * r, 0}, r);
    BondTable bonds;
    bonds.resize(2);
    Relaxation(p.forces, p.relaxation, r).relax(agents, bonds, {});
    const double distance = (agents.position(1) - agents.position(0)).norm();
    // The force 8 C sqrt(R) d^1.5 is at the tolerance for d = 3.2e-5 r. FIRE may take one last step of each
    // beyond touching.
    EXPECT_GT(distance, (2 - 4e-5) * r) << minimiser;
    EXPECT_LT(distance, (2 + 2 * p.relaxation.stepLimit) * r) << minimiser;
  }
}

TEST(Equilibrium, ACompressedChainSharesItsOverlapAndPushesAsTheLawSays) {
  for (const auto law : contactLawNames()) {
    for (const auto minimiser : minimiserNames()) {
      const auto p = with(law, minimiser, 1e-7);
      const int spheres = 12;
      const double spacing = 1.7 * r;
      AgentStore agents;
      for (int k = 0; k < spheres; ++k) {
        RandomStream random(4, k, 0, RandomPurpose::packing);
        const bool end = k == 0 || k == spheres - 1;
        agents.append(AgentKind::smc, {k * spacing + (end ? 0 : 0.2 * r * (random.uniform() - 0.5)), 0, 0},
                      r);
        agents.set(k, AgentFlag::fixed, end);
      }
      BondTable bonds;
      bonds.resize(agents.size());
      Relaxation(p.forces, p.relaxation, r).relax(agents, bonds, {});
      for (int k = 0; k < spheres; ++k)
        EXPECT_NEAR(agents.x[k], k * spacing, 1e-5 * r) << law << ' ' << minimiser;
      const double force = -ForceField(p.forces).evaluate(agents, bonds)[0].fx;
      EXPECT_NEAR(force / lawForce(law, p, 0.3 * r), 1, 1e-5);
    }
  }
}

TEST(Equilibrium, AStretchedBondedChainHasTheModulusOfItsBonds) {
  const auto p = with("hertzNeoHookean", "fire", 1e-7);
  const int spheres = 12;
  const double rest = 2 * r, strain = 0.1;
  AgentStore agents;
  for (int k = 0; k < spheres; ++k) {
    // All of the stretch in the last bond to begin with.
    agents.append(AgentKind::smc, {0, 0, k * rest + (k == spheres - 1 ? (spheres - 1) * strain * rest : 0)},
                  r);
    agents.set(k, AgentFlag::fixed, k == 0 || k == spheres - 1);
  }
  BondTable bonds;
  bonds.resize(agents.size());
  for (int k = 1; k < spheres; ++k) bonds.connect(k - 1, k, rest);
  Relaxation(p.forces, p.relaxation, r).relax(agents, bonds, {});
  for (int k = 1; k < spheres; ++k) EXPECT_NEAR((agents.z[k] - agents.z[k - 1]) / rest, 1 + strain, 1e-5);
  const double force = ForceField(p.forces).evaluate(agents, bonds)[0].fz;
  EXPECT_NEAR(force / (p.forces.bondModulus * strain * 4 * r * r), 1, 1e-5);
}

/// A bonded block of agents on a disturbed face-centred lattice between two fixed layers.
struct Block {
  AgentStore agents;
  BondTable bonds;

  explicit Block(int n) {
    const double spacing = 1.9 * r / std::sqrt(2.0);
    for (int z = 0; z < n; ++z) {
      for (int y = 0; y < n; ++y) {
        for (int x = (y + z) % 2; x < n; x += 2) {
          RandomStream random(1, agents.nextId, 0, RandomPurpose::packing);
          const Vec3 noise = 0.1 * r * random.uniform() * random.direction();
          agents.set(agents.append(AgentKind::smc, Vec3(x, y, z) * spacing + noise, r), AgentFlag::fixed,
                     z == 0 || z == n - 1);
        }
      }
    }
    bonds.resize(agents.size());
    for (Index i = 0; i < agents.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        const double distance = (agents.position(i) - agents.position(j)).norm();
        if (distance < 2.1 * r) bonds.connect(i, j, distance);
      }
    }
  }
};

double largestDifference(const AgentStore& a, const AgentStore& b) {
  double largest = 0;
  for (Index i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position(i) - b.position(i)).norm());
  return largest;
}

TEST(Equilibrium, IsTheSameByBothMinimisersAndAnyAxialFactor) {
  for (const auto law : contactLawNames()) {
    AgentStore reference;
    for (const auto minimiser : minimiserNames()) {
      for (const double axialFactor : {1.0, 2.0}) {
        auto p = with(law, minimiser, 1e-5);
        p.relaxation.axialForceFactor = axialFactor;
        Block block(10);
        Relaxation(p.forces, p.relaxation, r).relax(block.agents, block.bonds, {});
        if (reference.size() == 0) reference = block.agents;
        EXPECT_LT(largestDifference(reference, block.agents), 1e-3 * r)
            << law << ' ' << minimiser << ' ' << axialFactor;
      }
    }
  }
}

TEST(Equilibrium, OfAGrowingCellIsTheSameWithSleepersAndWithout) {
  // At the tolerance of a run only the surroundings of the grown cell wake; at a thousandth of it the whole
  // block does.
  Block block(16);
  Relaxation exact({}, with("hertzNeoHookean", "fire", 1e-7).relaxation, r);
  exact.relax(block.agents, block.bonds, {});
  const Index grown = block.agents.size() / 2 + 4;
  ASSERT_FALSE(block.agents.has(grown, AgentFlag::fixed));
  block.agents.radius[grown] *= 1.03;

  Block lazy = block;
  const auto lazyReport = Relaxation({}, with("hertzNeoHookean", "fire", 2.5e-5).relaxation, r)
                              .relax(lazy.agents, lazy.bonds, {});
  const AgentStore before = block.agents;
  const auto exactReport = exact.relax(block.agents, block.bonds, {});

  EXPECT_GT(exactReport.agentEvaluations, 0.5 * exactReport.iterations * block.agents.size());
  EXPECT_LT(lazyReport.agentEvaluations,
            0.3 * lazyReport.iterations * block.agents.size() + block.agents.size());
  EXPECT_LT(largestDifference(lazy.agents, block.agents), 0.1 * largestDifference(before, block.agents));
}

TEST(Equilibrium, OfAPulledWallTakesSleepersNotManyTimesTheIterationsOfAllAwake) {
  // Taut bonds are stiff: a hundredth of a radius that one agent moves is much for the next. Were sleepers
  // looked at as late as suits soft daughters, they would be found one after another, in eighty times the
  // iterations.
  const auto pulled = [](bool sleeping) {
    Block block(16);
    auto p = with("hertzNeoHookean", "fire", 0.001);
    p.relaxation.activeSet = sleeping;
    Relaxation relaxation(p.forces, p.relaxation, r);
    RelaxationReport all = relaxation.relax(block.agents, block.bonds, {});
    const double end = *std::ranges::max_element(block.agents.z);
    for (int step = 0; step < 20; ++step) {
      for (Index i = 0; i < block.agents.size(); ++i) {
        if (block.agents.has(i, AgentFlag::fixed) && block.agents.z[i] > end - r)
          block.agents.z[i] += 0.01 * r;
      }
      all.append(relaxation.relax(block.agents, block.bonds, {}));
    }
    return all;
  };
  const RelaxationReport sleeping = pulled(true), awake = pulled(false);
  EXPECT_TRUE(sleeping.converged);
  EXPECT_TRUE(awake.converged);
  EXPECT_LT(sleeping.iterations, 20 * awake.iterations);
  EXPECT_LT(sleeping.agentEvaluations, 3 * awake.agentEvaluations);
}

}  // namespace
}  // namespace restenosis
