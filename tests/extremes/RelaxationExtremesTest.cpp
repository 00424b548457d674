// Starts that no run should bring about: the relaxation ends at an equilibrium, or says which setting to
// change.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/Constants.h"
#include "tests/support/Mechanics.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/equilibrium/Minimiser.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/forces/ContactLaws.h"

namespace restenosis {
namespace {

using namespace support;

BondTable noBonds(const AgentStore& agents) {
  BondTable bonds;
  bonds.resize(agents.size());
  return bonds;
}

bool allFinite(const AgentStore& agents) {
  for (Index i = 0; i < agents.size(); ++i) {
    if (!agents.position(i).allFinite() || !std::isfinite(agents.stress[i])) return false;
  }
  return true;
}

double largestDistance(const AgentStore& agents) {
  double largest = 0;
  for (Index i = 0; i < agents.size(); ++i) largest = std::max(largest, agents.position(i).norm());
  return largest;
}

/// Smallest distance of two agents over the sum of their radii.
double closest(const AgentStore& agents) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < agents.size(); ++i) {
    for (Index j = 0; j < i; ++j)
      smallest = std::min(
          smallest, (agents.position(i) - agents.position(j)).norm() / (agents.radius[i] + agents.radius[j]));
  }
  return smallest;
}

TEST(RelaxationExtremes, CoincidingCentresComeApart) {
  for (const auto law : contactLawNames()) {
    for (const auto minimiser : minimiserNames()) {
      for (const Index count : {2u, 3u, 30u}) {
        Mechanics p;
        p.forces.contactLaw = law, p.relaxation.minimiser = minimiser;
        AgentStore agents;
        for (Index i = 0; i < count; ++i) agents.append(AgentKind::smc, {1e-4, 2e-4, 3e-4}, r);
        const auto report = Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
        EXPECT_TRUE(report.converged) << law << ' ' << minimiser << ' ' << count;
        EXPECT_TRUE(allFinite(agents));
        // Thirty of them push each other no further than in a row.
        EXPECT_LT(largestDistance(agents), 1e-3);
        if (count == 2) {
          EXPECT_GT(closest(agents), 0.95);
        }
      }
    }
  }
}

/// A column between two fixed cells, all of its shortening in the first half.
AgentStore halfCompressedColumn(Index cells) {
  AgentStore agents;
  for (Index k = 0; k < cells; ++k) {
    const double spacings = 0.8 * std::min(k, cells / 2) + (k > cells / 2 ? k - cells / 2 : 0);
    agents.append(AgentKind::smc, {0, 0, spacings * 2 * r}, r);
    agents.set(k, AgentFlag::fixed, k == 0 || k == cells - 1);
  }
  return agents;
}

TEST(RelaxationExtremes, AColumnOfAThousandCompressedCellsStaysAColumn) {
  Mechanics p;
  p.relaxation.tolerance = 0.004;  // what evens out along so long a column takes its length squared in steps
  AgentStore agents = halfCompressedColumn(1000);
  const auto report = Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
  EXPECT_TRUE(report.converged);
  double widest = 0, narrowest = 1;
  for (Index k = 1; k < agents.size(); ++k) {
    const double spacing = (agents.z[k] - agents.z[k - 1]) / (2 * r);
    widest = std::max(widest, spacing), narrowest = std::min(narrowest, spacing);
    ASSERT_EQ(agents.x[k], 0);
  }
  EXPECT_LT(widest, 1.01);
  EXPECT_GT(narrowest, 0.799);
}

TEST(RelaxationExtremes, AColumnOfAHundredSharesItsLoad) {
  Mechanics p;
  p.relaxation.maximumIterations = 20000;
  p.relaxation.tolerance = 1e-5;  // a hundred times this is still little against the force in the column
  AgentStore agents = halfCompressedColumn(100);
  const double even = agents.z[99] / 99;
  Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
  for (Index k = 1; k < agents.size(); ++k) EXPECT_NEAR((agents.z[k] - agents.z[k - 1]) / even, 1, 1e-3) << k;
}

TEST(RelaxationExtremes, ACellFarFromAllOthersStaysWhereItIs) {
  for (const auto* precision : {"mixed", "double"}) {
    Mechanics p;
    p.relaxation.precision = precision;
    AgentStore agents;
    for (int k = 0; k < 10; ++k) agents.append(AgentKind::smc, {k * 1.5 * r, 0, 0}, r);
    const Vec3 far(1.0, -2.0, 3.0);  // metres
    const Index alone = agents.append(AgentKind::smc, far, r);
    Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
    EXPECT_EQ(agents.position(alone), far) << precision;
    EXPECT_GT(agents.x[9] - agents.x[0], 9 * 1.9 * r);
  }
}

TEST(RelaxationExtremes, OneAgentIsAtRest) {
  AgentStore agents;
  agents.append(AgentKind::smc, {1e-4, 0, 0}, r);
  const auto report = Relaxation({}, {}, r).relax(agents, noBonds(agents), {});
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(agents.position(0), Vec3(1e-4, 0, 0));
}

TEST(RelaxationExtremes, NoAgentsAreAtRest) {
  AgentStore agents;
  EXPECT_TRUE(Relaxation({}, {}, r).relax(agents, noBonds(agents), {}).converged);
}

/// A ball of agents a quarter of their size apart: each is far inside dozens of others.
AgentStore crushedBall() {
  AgentStore agents;
  for (int z = -3; z <= 3; ++z) {
    for (int y = -3; y <= 3; ++y) {
      for (int x = -3; x <= 3; ++x) {
        RandomStream random(1, agents.nextId, 0, RandomPurpose::packing);
        agents.append(AgentKind::smc, (Vec3(x, y, z) + 0.2 * random.direction()) * 0.5 * r, r);
      }
    }
  }
  return agents;
}

// T6 reports an implosion: cells that are pressed past the pole of the law attract each other and fall
// together.
TEST(RelaxationExtremes, ACrushedBallExplodesNoFurtherThanItsSizeAndNeverImplodes) {
  for (const auto law : contactLawNames()) {
    for (const auto minimiser : minimiserNames()) {
      Mechanics p;
      p.forces.contactLaw = law, p.relaxation.minimiser = minimiser;
      AgentStore agents = crushedBall();
      const auto report = Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
      EXPECT_TRUE(report.converged);
      EXPECT_GT(closest(agents), 0.9) << law << ' ' << minimiser;
      // 343 cells at the density of a loose packing fill a ball of 9 r; nobody is flung away.
      EXPECT_LT(largestDistance(agents), 25 * r) << law << ' ' << minimiser;
    }
  }
}

TEST(RelaxationExtremes, SizesAHundredToOneComeApartToo) {
  for (const auto law : contactLawNames()) {
    Mechanics p;
    p.forces.contactLaw = law;
    p.relaxation.maximumIterations = 100000;
    AgentStore agents;
    agents.append(AgentKind::smc, Vec3::Zero(), 100 * r);
    agents.append(AgentKind::smc, {0.3 * r, 0, 0}, r);  // deep inside, past the pole
    const auto report = Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {});
    EXPECT_TRUE(report.converged) << law;
    EXPECT_GT(closest(agents), 0.99) << law;
    EXPECT_LT(closest(agents), 1.01) << law;
  }
}

TEST(RelaxationExtremes, StepsAHundredTimesTooLargeEndSomewhereOrSayWhatToChange) {
  for (const auto minimiser : minimiserNames()) {
    Mechanics p;
    p.relaxation.minimiser = minimiser;
    p.relaxation.stepLimit *= 100;
    AgentStore agents = crushedBall();
    try {
      EXPECT_TRUE(Relaxation(p.forces, p.relaxation, r).relax(agents, noBonds(agents), {}).converged);
    } catch (const RelaxationFailed& failure) {
      EXPECT_NE(std::string(failure.what()).find("relaxation.maximumIterations"), std::string::npos);
    }
    EXPECT_TRUE(allFinite(agents));
    EXPECT_LT(largestDistance(agents), 1e-2) << minimiser;
  }
}

}  // namespace
}  // namespace restenosis
