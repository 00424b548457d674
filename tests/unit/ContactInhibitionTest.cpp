#include <gtest/gtest.h>
#include <omp.h>

#include <map>
#include <numeric>

#include "tests/support/Constants.h"
#include "tests/support/RandomPacking.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/biology/ContactInhibition.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double side = 18 * r;

const AgentStore& packing() {
  static const AgentStore agents = [] {
    AgentStore packed;
    support::appendRandomPacking(packed, {side, side, side}, r);
    return packed;
  }();
  return agents;
}

ContactInhibition evaluator(double vesselLength = 0, const ContactInhibitionParameters& parameters = {}) {
  return {parameters, makeContactInhibitionLaw(parameters), vesselLength};
}

/// Distance from the nearest of the four faces beside the axis [r].
double depth(const AgentStore& agents, Index i) {
  return std::min({agents.x[i], side - agents.x[i], agents.y[i], side - agents.y[i]}) / r;
}
double axialDepth(const AgentStore& agents, Index i) { return std::min(agents.z[i], side - agents.z[i]) / r; }

std::map<AgentId, std::uint8_t> flagsById(const AgentStore& agents) {
  std::map<AgentId, std::uint8_t> flags;
  for (Index i = 0; i < agents.size(); ++i) flags[agents.id[i]] = agents.flags[i];
  return flags;
}

/// Moves every agent by up to `step` r in a random direction.
void jiggle(AgentStore& agents, double step, std::uint32_t round) {
  for (Index i = 0; i < agents.size(); ++i) {
    RandomStream random(5, agents.id[i], round, RandomPurpose::packing);
    const double length = step * r * random.uniform();
    agents.setPosition(i, agents.position(i) + length * random.direction());
  }
}

TEST(ContactInhibition, TellsTheSurfaceOfADensePackingFromItsInterior) {
  AgentStore agents = packing();
  evaluator().evaluate(agents);
  int interior = 0, surface = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    const double nearest = std::min(depth(agents, i), axialDepth(agents, i));
    EXPECT_NE(agents.has(i, inhibited), agents.has(i, exposed));
    if (nearest > 4.2) {
      EXPECT_TRUE(agents.has(i, inhibited)) << agents.id[i];
      ++interior;
    }
    if (nearest < 0.3) {
      EXPECT_FALSE(agents.has(i, inhibited)) << agents.id[i];
      ++surface;
    }
  }
  EXPECT_GT(interior, 80);
  EXPECT_GT(surface, 80);
}

TEST(ContactInhibition, SeesTheWallGoOnBeyondTheEndsOfTheVessel) {
  AgentStore open = packing(), closed = packing();
  evaluator().evaluate(open);
  evaluator(side).evaluate(closed);
  int atEnds = 0, exposedAtOpenEnds = 0;
  for (Index i = 0; i < open.size(); ++i) {
    if (depth(open, i) < 4.2 || axialDepth(open, i) > 0.5) continue;
    ++atEnds;
    exposedAtOpenEnds += open.has(i, exposed);
    EXPECT_FALSE(closed.has(i, exposed)) << open.id[i];
  }
  EXPECT_GT(atEnds, 10);
  EXPECT_EQ(exposedAtOpenEnds, atEnds);
  int surface = 0;
  for (Index i = 0; i < open.size(); ++i) {
    if (depth(open, i) > 0.3) continue;
    EXPECT_TRUE(closed.has(i, exposed)) << open.id[i];
    ++surface;
  }
  EXPECT_GT(surface, 40);
}

TEST(ContactInhibition, JudgesOnlyCellsThatCouldUseIt) {
  AgentStore agents = packing();
  for (Index i = 0; i < agents.size(); ++i) agents.set(i, synthetic, i % 2 == 0);
  agents.set(0, fixed, true);
  agents.set(1, exposed, true);
  auto inhibition = evaluator();
  EXPECT_EQ(inhibition.evaluate(agents).evaluated, (agents.size() + 1) / 2 - 1);
  for (Index i = 1; i < agents.size(); i += 2) EXPECT_EQ(agents.flags[i], 0);
  EXPECT_EQ(agents.flags[0], synthetic | fixed);
  agents.set(0, fixed, false);
  agents.set(1, synthetic, true);
  EXPECT_EQ(inhibition.evaluate(agents).evaluated, 2u);
  EXPECT_TRUE(agents.has(0, inhibited) || agents.has(0, exposed));
}

TEST(ContactInhibition, DoesNoWorkWhileNothingMoves) {
  AgentStore agents = packing();
  auto inhibition = evaluator();
  inhibition.evaluate(agents);
  const auto flags = agents.flags;
  agents.set(7, inhibited, !agents.has(7, inhibited));
  const auto report = inhibition.evaluate(agents);
  EXPECT_EQ(report.evaluated, 0u);
  EXPECT_EQ(report.disturbances, 0u);
  EXPECT_EQ(agents.flags, flags);
}

TEST(ContactInhibition, IsTheFullEvaluationWithoutATolerance) {
  ContactInhibitionParameters parameters;
  parameters.changeTolerance = 0;
  AgentStore agents = packing();
  auto inhibition = evaluator(side, parameters);
  inhibition.evaluate(agents);
  bool fewer = false;
  for (std::uint32_t round = 0; round < 5; ++round) {
    for (Index i = round; i < agents.size(); i += 100) {
      agents.setPosition(i, agents.position(i) + Vec3(0.5 * r, 0.3 * r, -0.5 * r));
    }
    agents.radius[round] *= 1.3;
    agents.append(AgentKind::smc, agents.position(3 * round) + Vec3(r, 0, 0), r);
    std::vector<std::uint8_t> gone(agents.size(), 0);
    gone[10 * round + 5] = 1;
    agents.erase(gone);
    fewer |= inhibition.evaluate(agents).evaluated < agents.size() - 100;
    AgentStore afresh = agents;
    evaluator(side, parameters).evaluate(afresh);
    EXPECT_EQ(agents.flags, afresh.flags) << round;
  }
  EXPECT_TRUE(fewer);
}

TEST(ContactInhibition, StaysWithinItsTolerance) {
  // Steps below the tolerance must not add up unseen. Every position behind the flags is within 0.02 r of the
  // true one, so few cells can differ from a full evaluation: those within a direction or so of the
  // threshold.
  AgentStore agents = packing();
  auto inhibition = evaluator(side);
  for (std::uint32_t round = 0; round < 20; ++round) {
    jiggle(agents, 0.01, round);
    inhibition.evaluate(agents);
  }
  AgentStore afresh = agents;
  evaluator(side).evaluate(afresh);
  int differing = 0;
  for (Index i = 0; i < agents.size(); ++i) differing += agents.flags[i] != afresh.flags[i];
  EXPECT_LT(differing, 0.02 * agents.size());
}

TEST(ContactInhibition, GoesOnFromAnArchiveBitForBit) {
  AgentStore agents = packing();
  auto inhibition = evaluator(side);
  inhibition.evaluate(agents);
  jiggle(agents, 0.03, 0);
  inhibition.evaluate(agents);

  WritingArchive out;
  out(agents, inhibition);
  AgentStore restoredAgents;
  auto restored = evaluator(side);
  ReadingArchive in(out.buffer());
  in(restoredAgents, restored);
  EXPECT_TRUE(in.atEnd());
  for (std::uint32_t round = 1; round < 4; ++round) {
    jiggle(agents, 0.03, round);
    jiggle(restoredAgents, 0.03, round);
    EXPECT_EQ(inhibition.evaluate(agents).evaluated, restored.evaluate(restoredAgents).evaluated);
    EXPECT_EQ(agents.flags, restoredAgents.flags);
  }
}

TEST(ContactInhibition, DependsNeitherOnTheOrderOfAgentsNorOnThreads) {
  for (const std::string law : {"exposure", "neighbourCount"}) {
    ContactInhibitionParameters parameters;
    parameters.law = law;
    AgentStore agents = packing(), shuffled = packing();
    auto inhibition = evaluator(side, parameters), other = evaluator(side, parameters);
    inhibition.evaluate(agents);
    other.evaluate(shuffled);
    std::vector<Index> order(shuffled.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::reverse(order);
    std::swap(order[3], order[77]);
    shuffled.reorder(order);
    const int threads = omp_get_max_threads();
    for (std::uint32_t round = 0; round < 3; ++round) {
      jiggle(agents, 0.05, round);
      jiggle(shuffled, 0.05, round);
      omp_set_num_threads(1);
      const auto evaluated = inhibition.evaluate(agents).evaluated;
      omp_set_num_threads(3);
      EXPECT_EQ(other.evaluate(shuffled).evaluated, evaluated);
      EXPECT_EQ(flagsById(agents), flagsById(shuffled)) << law;
    }
    omp_set_num_threads(threads);
  }
}

TEST(ContactInhibition, InhibitsNothingWithoutALaw) {
  AgentStore agents = packing();
  ContactInhibition(ContactInhibitionParameters{}, nullptr, 0).evaluate(agents);
  int exposedCells = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    EXPECT_FALSE(agents.has(i, inhibited));
    exposedCells += agents.has(i, exposed);
  }
  EXPECT_GT(exposedCells, 100);
}

}  // namespace
}  // namespace restenosis
