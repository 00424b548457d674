#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/biology/Activation.h"
#include "tissue/biology/Biology.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore cellsAtRest(Index count, float activation) {
  AgentStore agents;
  agents.activation.model(0);
  for (Index i = 0; i < count; ++i) {
    agents.append(AgentKind::smc, Vec3::Zero(), r);
    agents.set(i, synthetic, true);
    agents.activation.set(i, activation);
  }
  return agents;
}

ActivationParameters parameters(double ratePerDay, double decayDays) {
  ActivationParameters p;
  p.entryRate = ratePerDay / oneDay, p.decayTime = decayDays * oneDay;
  return p;
}

TEST(Activation, RisesEvenlyWithStretchFromOnsetToFull) {
  ActivationParameters p;
  p.stretchOnset = 0.1, p.stretchFull = 0.3;
  const Activation activation(p, 1, hour);
  EXPECT_EQ(activation.byStretch(-1), 0);
  EXPECT_EQ(activation.byStretch(0.1), 0);
  EXPECT_NEAR(activation.byStretch(0.15), 0.25, 1e-12);
  EXPECT_EQ(activation.byStretch(0.3), 1);
  EXPECT_EQ(activation.byStretch(5), 1);
  p.stretchOnset = p.stretchFull = 0.2;  // a step
  EXPECT_EQ(Activation(p, 1, hour).byStretch(0.2), 1);
  EXPECT_EQ(Activation(p, 1, hour).byStretch(std::nextafter(0.2, 0)), 0);
}

TEST(Activation, IsFullForSyntheticCellsAndMakesStretchedOnesSynthetic) {
  AgentStore agents = cellsAtRest(5, 0);
  for (const Index i : {1, 2, 3}) agents.set(i, synthetic, false);
  agents.set(3, fixed, true);
  agents.kind[4] = AgentKind::iel;
  const Activation activation(parameters(1, 1), 1, hour);
  activation.stretch(agents, std::vector<double>{0, 0.15, 0, 1, 1});
  EXPECT_EQ(activation.activate(agents), 1U);
  const std::vector<float> expected{1, static_cast<float>(activation.byStretch(0.15)), 0, 0, 0};
  EXPECT_EQ(agents.activation.values(), expected);
  EXPECT_TRUE(agents.has(1, synthetic));
  EXPECT_FALSE(agents.has(2, synthetic));
  EXPECT_FALSE(agents.has(3, synthetic)) << "it does not cycle";
}

TEST(Activation, EntersByTheHazardOfItsDecayingLevel) {
  const Index cells = 20000;
  const double rate = 3, decay = 0.5, level = 0.5;
  const AgentStore agents = cellsAtRest(cells, level);
  const Activation activation(parameters(rate, decay), 7, hour);
  std::vector<double> entries;
  for (Index i = 0; i < cells; ++i) {
    const double entry = activation.entry(agents, i, oneDay, 5);
    if (std::isfinite(entry)) entries.push_back(entry);
  }
  const auto probability = [&](double time) {
    return -std::expm1(rate * level * decay * std::expm1(-time / (decay * oneDay)));
  };
  for (const double time : {0.1 * oneDay, 0.3 * oneDay, oneDay}) {
    const auto entered = std::ranges::count_if(entries, [&](double entry) { return entry <= time; });
    const double p = probability(time);
    EXPECT_NEAR(static_cast<double>(entered), cells * p, 4 * std::sqrt(cells * p * (1 - p))) << time;
  }
}

TEST(Activation, EntersNeverWithoutActivationOrRateAndAtOnceWithAHugeOne) {
  const AgentStore none = cellsAtRest(1, 0), full = cellsAtRest(1, 1);
  EXPECT_EQ(Activation(parameters(1e4, 1), 1, hour).entry(none, 0, oneDay, 0), INFINITY);
  EXPECT_EQ(Activation(parameters(0, 1), 1, hour).entry(full, 0, oneDay, 0), INFINITY);
  EXPECT_LT(Activation(parameters(1e4, 1e6), 1, hour).entry(full, 0, oneDay, 0), hour);
  // Over before it begins
  EXPECT_EQ(Activation(parameters(1e4, 1e-9), 1, hour).entry(full, 0, oneDay, 0), INFINITY);
}

TEST(Activation, DecaysExponentially) {
  AgentStore agents = cellsAtRest(1, 1);
  const Activation activation(parameters(1, 10), 1, hour);
  double mean = 0;
  for (int step = 0; step < 240; ++step) {
    mean += agents.activation[0] * activation.meanOverStep() / 240;
    activation.decay(agents);
  }
  EXPECT_NEAR(agents.activation[0], std::exp(-1.0), 1e-5);
  EXPECT_NEAR(mean, 1 - std::exp(-1.0), 1e-5);
}

/// Cells that nothing holds, for `days` in steps of `step` [s]. Returns the share of those that entered G1.
double shareEntered(const ActivationParameters& p, double days, double step) {
  BiologySettings settings;
  settings.cellCycle.emplace();
  settings.cellCycle->g1Mean = 1e4 * hour;  // none comes back to rest
  settings.activation = p;
  settings.step = step;
  const Biology biology(settings);
  AgentStore agents = cellsAtRest(20000, 1);
  BondTable bonds;
  bonds.resize(agents.size());
  for (int n = 0; n * step < days * oneDay; ++n) biology.advanceCycle(agents, bonds, n * step);
  return static_cast<double>(std::ranges::count(agents.state, CycleState::g1)) / agents.size();
}

TEST(Activation, LetsACellEnterWithTheProbabilityOfTheWholeHazardWhateverTheStep) {
  const double rate = 0.25, decay = 10, days = 20;
  const double expected = -std::expm1(rate * decay * std::expm1(-days / decay));
  const double spread = std::sqrt(expected * (1 - expected) / 20000);
  for (const double step : {hour, 6 * hour, 2 * oneDay})
    EXPECT_NEAR(shareEntered(parameters(rate, decay), days, step), expected, 4 * spread) << step;
}

TEST(Activation, IsInheritedByDaughters) {
  AgentStore agents = cellsAtRest(1, 0.3F);
  BondTable bonds;
  bonds.resize(1);
  const std::vector<Index> mothers{0};
  Division(1, 0.4).divide(agents, bonds, mothers);
  EXPECT_EQ(agents.activation[1], 0.3F);
}

TEST(Activation, LeavesNothingInTheStateWhereItIsNotModelled) {
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3::Zero(), r);
  EXPECT_EQ(agents.activation[0], 0);
  EXPECT_TRUE(agents.activation.values().empty());
}

}  // namespace
}  // namespace restenosis
