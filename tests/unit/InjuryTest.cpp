#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/stent/Injury.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/WallBonds.h"

namespace restenosis {
namespace {

using namespace support;

/// A small cylinder of IEL with a layer of cells under it, bonded, its ends fixed, then stretched around in
/// the middle by `around` and along by `along`.
Wall stretchedWall(double around, double along) {
  Wall wall;
  wall.length = 0.6e-3;
  wall.lumenRadius = 0.2e-3;
  wall.cellRadius = r;
  for (int k = 0; k <= 20; ++k) {
    for (int n = 0; n < 48; ++n) {
      const double angle = 2 * std::numbers::pi * n / 48;
      wall.agents.append(AgentKind::iel, toCartesian({0.22e-3, angle, 2 * r * k}), r);
      wall.agents.append(AgentKind::smc, toCartesian({0.25e-3, angle, 2 * r * k}), r);
    }
  }
  bondWall(wall, 1.1);
  fixEnds(wall, 2.5);
  for (Index i = 0; i < wall.agents.size(); ++i) {
    Cylindrical c = toCylindrical(wall.agents.position(i));
    const bool middle = !wall.agents.has(i, fixed);
    if (middle) c.radius *= 1 + around;
    c.z = 0.3e-3 + (c.z - 0.3e-3) * (1 + along);
    wall.agents.setPosition(i, toCartesian(c));
  }
  return wall;
}

InjuryParameters alwaysFenestrated() {
  InjuryParameters parameters;
  parameters.fenestrationProbability = 1;
  parameters.endMargin = 0;
  return parameters;
}

TEST(Injury, AWallAtRestIsNotInjured) {
  Wall wall = stretchedWall(0, 0);
  InjuryParameters parameters = alwaysFenestrated();
  parameters.ielBreaks = true;
  const InjuryReport report = injure(wall, parameters, 1);
  EXPECT_EQ(report.stretched, 0u);
  EXPECT_EQ(report.broken, 0u);
  EXPECT_EQ(report.synthetic, 0u);
  EXPECT_GT(report.iel, 0u);
  EXPECT_NEAR(report.largestStrain, 0, 1e-6);
}

TEST(Injury, FenestrationTakesTheStatedShareOfTheStretched) {
  Index fenestrated = 0, stretched = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Wall wall = stretchedWall(0.2, 0);
    InjuryParameters parameters;
    parameters.fenestrationProbability = 0.3;
    parameters.endMargin = 0;
    const InjuryReport report = injure(wall, parameters, seed);
    fenestrated += report.fenestrated, stretched += report.stretched;
  }
  ASSERT_GT(stretched, 10000u);
  // Four standard errors of a binomial.
  EXPECT_NEAR(fenestrated, 0.3 * stretched, 4 * std::sqrt(0.21 * stretched));
}

TEST(Injury, InjuredIelBecomesSyntheticMuscleWithWhatIsNear) {
  Wall wall = stretchedWall(0.2, 0);
  const Wall before = wall;
  const InjuryReport report = injure(wall, alwaysFenestrated(), 1);
  EXPECT_EQ(report.fenestrated, report.stretched);
  EXPECT_EQ(wall.bonds.bondCount(), before.bonds.bondCount());
  for (Index i = 0; i < wall.agents.size(); ++i) {
    const bool end = wall.agents.has(i, fixed);
    EXPECT_EQ(wall.agents.has(i, injuredIel), before.agents.kind[i] == AgentKind::iel && !end);
    EXPECT_EQ(wall.agents.has(i, synthetic), !end);  // the one layer of cells is all within reach
    if (wall.agents.has(i, injuredIel)) {
      EXPECT_EQ(wall.agents.kind[i], AgentKind::smc);
    }
  }
}

TEST(Injury, StaysAwayFromTheEnds) {
  const auto injuredBetween = [](double endMargin) {
    Wall wall = stretchedWall(0.2, 0);
    InjuryParameters parameters = alwaysFenestrated();
    parameters.endMargin = endMargin;
    injure(wall, parameters, 1);
    double first = wall.length, last = 0;
    for (Index i = 0; i < wall.agents.size(); ++i) {
      if (!wall.agents.has(i, injuredIel)) continue;
      first = std::min(first, wall.agents.z[i]), last = std::max(last, wall.agents.z[i]);
    }
    return std::pair(first, last);
  };
  // Rows lie 30 um apart; the first two and the last two are fixed.
  EXPECT_NEAR(injuredBetween(0).first, 60e-6, 1e-9);
  EXPECT_NEAR(injuredBetween(0.05e-3).first, 120e-6, 1e-9);
  EXPECT_NEAR(injuredBetween(0.05e-3).second, 480e-6, 1e-9);
  // Never more than a quarter of the free part, 480 um.
  EXPECT_NEAR(injuredBetween(1e-3).first, 180e-6, 1e-9);
}

TEST(Injury, ReachIsMeasuredInRadii) {
  Wall wall = stretchedWall(0.2, 0);
  InjuryParameters parameters = alwaysFenestrated();
  parameters.syntheticReach = 0.9;
  const InjuryReport report = injure(wall, parameters, 1);
  EXPECT_EQ(report.synthetic, report.fenestrated);
}

TEST(Injury, BreaksByTheLimitOfEachDirection) {
  InjuryParameters parameters;
  parameters.ielBreaks = true;
  parameters.fenestrationProbability = 0;
  const auto brokenAt = [&](double around, double along) {
    Wall wall = stretchedWall(around, along);
    return injure(wall, parameters, 1).broken;
  };
  parameters.strainLimitAround = 0.095, parameters.strainLimitAlong = 10;
  EXPECT_EQ(brokenAt(0, 0.3), 0u);
  EXPECT_GT(brokenAt(0.1, 0), 0u);
  EXPECT_LT(brokenAt(0.09, 0), brokenAt(0.1, 0));
  parameters.strainLimitAround = 10, parameters.strainLimitAlong = 0.05;
  EXPECT_EQ(brokenAt(0, 0.049), 0u);
  EXPECT_GT(brokenAt(0, 0.051), 0u);
}

TEST(Injury, BrokenBondsAreGoneAndTheirEndsAreCells) {
  Wall wall = stretchedWall(0.2, 0);
  const Wall before = wall;
  InjuryParameters parameters;
  parameters.ielBreaks = true;
  parameters.fenestrationProbability = 0;
  parameters.endMargin = 0;
  const InjuryReport report = injure(wall, parameters, 1);
  EXPECT_GT(report.brokenBonds, 0u);
  EXPECT_EQ(wall.bonds.bondCount(), before.bonds.bondCount() - report.brokenBonds);
  for (Index i = 0; i < wall.agents.size(); ++i) {
    if (wall.bonds.of(i).size() < before.bonds.of(i).size() && !wall.agents.has(i, fixed)) {
      EXPECT_TRUE(wall.agents.has(i, injuredIel));
      EXPECT_TRUE(wall.agents.has(i, synthetic));
    }
  }
  parameters.ielBreaks = false;
  Wall whole = before;
  EXPECT_EQ(injure(whole, parameters, 1).broken, 0u);
}

TEST(Injury, StressLimitBreaksInTensionAndInCompression) {
  InjuryParameters parameters;
  parameters.ielBreaks = true;
  parameters.stressLimit = 1e5;
  for (const double beyond : {-2e5, 2e5}) {
    Wall wall = stretchedWall(0, 0);
    for (Index i = 0; i < wall.agents.size(); ++i) wall.agents.stress[i] = i % 3 == 0 ? beyond : 0.5e5;
    const InjuryReport report = injure(wall, parameters, 1);
    EXPECT_GT(report.broken, 0u);
    EXPECT_LT(report.broken, report.iel / 2);
    EXPECT_EQ(report.brokenBonds, 0u);
  }
}

TEST(Injury, AllMakesEveryFreeCellSynthetic) {
  Wall wall = stretchedWall(0, 0);
  InjuryParameters parameters;
  parameters.synthetic = "all";
  const InjuryReport report = injure(wall, parameters, 1);
  Index cells = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    cells += wall.agents.kind[i] == AgentKind::smc && !wall.agents.has(i, fixed);
  }
  EXPECT_EQ(report.synthetic, cells);
}

TEST(Injury, RemovesTheIel) {
  Wall wall = stretchedWall(0, 0);
  InjuryParameters parameters;
  parameters.removeIel = true;
  const InjuryReport report = injure(wall, parameters, 1);
  EXPECT_EQ(report.removed, 21u * 48u);
  EXPECT_EQ(wall.agents.size(), 21u * 48u);
  EXPECT_EQ(wall.bonds.size(), wall.agents.size());
  EXPECT_GT(report.synthetic, 0u);
}

TEST(Injury, DenudationDecidesTheEndothelium) {
  for (const char* denudation : {"full", "none"}) {
    Wall wall = stretchedWall(0.2, 0);
    InjuryParameters parameters;
    parameters.denudation = denudation;
    injure(wall, parameters, 1);
    Index coveredAgents = 0;
    for (Index i = 0; i < wall.agents.size(); ++i) coveredAgents += wall.agents.has(i, covered);
    EXPECT_EQ(coveredAgents, parameters.denudation == "none" ? 21u * 48u : 0u);
  }
}

TEST(Injury, AWordThatIsNoneIsRefused) {
  Wall wall = stretchedWall(0.2, 0);
  InjuryParameters parameters;
  parameters.denudation = "ful";
  EXPECT_THROW(injure(wall, parameters, 1), std::invalid_argument);
  parameters = InjuryParameters();
  parameters.synthetic = "al";
  EXPECT_THROW(injure(wall, parameters, 1), std::invalid_argument);
}

TEST(Injury, DependsOnIdsNotOnTheOrderOfAgents) {
  Wall wall = stretchedWall(0.1, 0.05), ordered = wall;
  orderInSpace(ordered);
  InjuryParameters parameters;
  parameters.fenestrationProbability = 0.5;
  injure(wall, parameters, 7);
  injure(ordered, parameters, 7);
  orderInSpace(wall);
  HashingArchive one, other;
  one(wall), other(ordered);
  EXPECT_EQ(one.digest(), other.digest());
}

TEST(Injury, ParametersSayWhetherTheIelOfAPackedWallStaysWhole) {
  InjuryParameters parameters;
  EXPECT_TRUE(parameters.sparesIel(false));
  EXPECT_FALSE(parameters.sparesIel(true)) << "a stent stretches it";
  parameters.removeIel = true;
  EXPECT_FALSE(parameters.sparesIel(false));
  parameters.removeIel = false;
  parameters.stretchedStrain = 0;
  EXPECT_FALSE(parameters.sparesIel(false)) << "it is past that limit as it is packed";
}

}  // namespace
}  // namespace restenosis
