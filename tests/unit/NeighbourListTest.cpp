#include <gtest/gtest.h>
#include <omp.h>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {
namespace {

/// Agents with radii from 1 to `ratio` um, every fifth a daughter.
AgentStore mixed(int count, double ratio) {
  AgentStore agents;
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  for (int k = 0; k < count; ++k) {
    const Vec3 place(random.uniform(), random.uniform(), random.uniform());
    const Index i = agents.append(AgentKind::smc, 1e-4 * place, 1e-6 * std::pow(ratio, random.uniform()));
    agents.set(i, AgentFlag::daughter, k % 5 == 0);
  }
  return agents;
}

std::vector<Index> inRange(const AgentStore& agents, const NeighbourRange& range, Index i) {
  std::vector<Index> found;
  for (Index j = 0; j < agents.size(); ++j) {
    const bool daughter = agents.has(i, AgentFlag::daughter) || agents.has(j, AgentFlag::daughter);
    const double reach =
        (daughter ? range.daughterFactor : range.factor) * (agents.radius[i] + agents.radius[j]) + range.skin;
    if (i != j && (agents.position(i) - agents.position(j)).norm() <= reach) found.push_back(j);
  }
  return found;
}

TEST(NeighbourList, HoldsExactlyThePairsInRangeInAscendingOrder) {
  for (const double ratio : {1.0, 3.0, 100.0}) {
    const AgentStore agents = mixed(400, ratio);
    const NeighbourRange range{.factor = 1, .daughterFactor = 1.3, .skin = 2e-6};
    NeighbourList list;
    list.build(agents, range);
    for (Index i = 0; i < agents.size(); ++i) {
      const auto expected = inRange(agents, range, i);
      ASSERT_EQ(std::vector<Index>(list.of(i).begin(), list.of(i).end()), expected) << ratio;
    }
  }
}

TEST(NeighbourList, IsTheSameForAnyNumberOfThreads) {
  const AgentStore agents = mixed(3000, 3);
  const int threads = omp_get_max_threads();
  NeighbourList one, three;
  omp_set_num_threads(1);
  one.build(agents, {.skin = 1e-6});
  omp_set_num_threads(3);
  three.build(agents, {.skin = 1e-6});
  omp_set_num_threads(threads);
  ASSERT_EQ(one.pairCount(), three.pairCount());
  for (Index i = 0; i < agents.size(); ++i) ASSERT_TRUE(std::ranges::equal(one.of(i), three.of(i)));
}

TEST(NeighbourList, TellsWhenAnAgentHasGoneSoFarThatAPairCouldBeMissing) {
  AgentStore agents = mixed(50, 2);
  NeighbourList list;
  list.build(agents, {.skin = 2e-6});
  const Vec3 start = agents.position(20);
  EXPECT_GE(list.margin(20, start + Vec3(0.99e-6, 0, 0)), 0);
  EXPECT_FALSE(list.margin(20, start + Vec3(1.01e-6, 0, 0)) >= 0);
  EXPECT_FALSE(list.margin(20, start + Vec3(NAN, 0, 0)) >= 0);
  agents.x[20] += 1.01e-6;
  list.update(agents, {.skin = 2e-6});
  EXPECT_GE(list.margin(20, agents.position(20)), 0);
  EXPECT_FALSE(list.margin(20, start) >= 0);
}

TEST(NeighbourList, KeepsEveryPairInRangeWhileAgentsMoveGrowAndCome) {
  AgentStore agents = mixed(1500, 2);
  const NeighbourRange range{.factor = 1, .daughterFactor = 1.3, .skin = 2e-6};
  NeighbourList list;
  list.update(agents, range);
  RandomStream random(7, 0, 0, RandomPurpose::packing);
  for (int step = 0; step < 30; ++step) {
    for (Index i = 0; i < agents.size(); ++i) {
      // Most creep, some jump; some grow, one of them shrinks as a dividing cell does.
      const double move = i % 50 == static_cast<Index>(step) ? 3e-6 : 0.03e-6;
      agents.setPosition(i, agents.position(i) + move * random.direction());
      if (i % 9 == 0) agents.radius[i] *= 1.01;
    }
    agents.radius[step] *= 0.7;
    agents.set(10 + step, AgentFlag::daughter, step % 2 == 0);
    if (step % 3 == 0) agents.append(AgentKind::smc, agents.position(40 + step), 1.5e-6);
    list.update(agents, range);
    ASSERT_EQ(list.size(), agents.size());
    const NeighbourRange contact{.factor = 1, .daughterFactor = 1.3, .skin = 0};
    for (Index i = 0; i < agents.size(); i += 7) {
      const auto row = list.of(i);
      ASSERT_EQ(std::ranges::adjacent_find(row, std::ranges::greater_equal()), row.end());
      ASSERT_TRUE(std::ranges::includes(row, inRange(agents, contact, i))) << step << ' ' << i;
    }
  }
}

TEST(NeighbourList, IsUpdatedForTheAgentsThatMovedOnly) {
  AgentStore agents = mixed(1500, 2);
  const NeighbourRange range{.factor = 1, .daughterFactor = 1.3, .skin = 2e-6};
  NeighbourList list;
  list.build(agents, range);
  RandomStream random(8, 0, 0, RandomPurpose::packing);
  std::size_t changed = 0;
  for (int step = 0; step < 40; ++step) {
    std::vector<Index> moved;
    for (Index i = static_cast<Index>(step % 10); i < agents.size(); i += 60) {
      moved.push_back(i);
      // Some go out of the box that the list was built for.
      agents.setPosition(i, agents.position(i) + (i % 7 == 0 ? 2e-5 : 0.6e-6) * random.direction());
    }
    const auto change = list.update(agents, moved);
    ASSERT_FALSE(change.all);
    changed += change.agents.size();
    for (Index i = 0; i < agents.size(); i += 5) {
      const auto row = list.of(i);
      ASSERT_TRUE(std::ranges::includes(row, inRange(agents, {.factor = 1, .daughterFactor = 1.3}, i)))
          << step << ' ' << i;
    }
  }
  EXPECT_GT(changed, 0u);
}

TEST(NeighbourList, StartsAnewForOtherAgents) {
  const NeighbourRange range{.skin = 1e-6};
  AgentStore agents = mixed(300, 2);
  NeighbourList list, fresh;
  list.update(agents, range);
  std::vector<Index> order(agents.size());
  for (Index k = 0; k < agents.size(); ++k) order[k] = agents.size() - 1 - k;
  agents.reorder(order);
  list.update(agents, range);
  fresh.build(agents, range);
  for (Index i = 0; i < agents.size(); ++i) ASSERT_TRUE(std::ranges::equal(list.of(i), fresh.of(i)));
  std::vector<std::uint8_t> remove(agents.size(), 0);
  remove[12] = 1;
  agents.erase(remove);
  list.update(agents, range);
  fresh.build(agents, range);
  for (Index i = 0; i < agents.size(); ++i) ASSERT_TRUE(std::ranges::equal(list.of(i), fresh.of(i)));
  agents.x[3] = std::nan("");
  EXPECT_THROW(list.update(agents, range), std::invalid_argument);
  agents.x[3] = 0;
  list.update(agents, range);
  fresh.build(agents, range);
  for (Index i = 0; i < agents.size(); ++i) ASSERT_TRUE(std::ranges::equal(list.of(i), fresh.of(i)));
}

}  // namespace
}  // namespace restenosis
