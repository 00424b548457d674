#include <gtest/gtest.h>
#include <omp.h>

#include "NeighbourList.h"
#include "RandomStream.h"

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

TEST(NeighbourList, AsksForARebuildOnceAPairCouldBeMissing) {
  AgentStore agents = mixed(50, 2);
  NeighbourList list;
  EXPECT_TRUE(list.needsRebuild(agents));
  list.build(agents, {.skin = 2e-6});
  EXPECT_FALSE(list.needsRebuild(agents));
  agents.x[20] += 0.99e-6;
  EXPECT_FALSE(list.needsRebuild(agents));
  agents.x[20] += 0.02e-6;
  EXPECT_TRUE(list.needsRebuild(agents));
  list.build(agents, {.skin = 2e-6});
  EXPECT_FALSE(list.needsRebuild(agents));
  agents.append(AgentKind::smc, {0, 0, 0}, 1e-6);
  EXPECT_TRUE(list.needsRebuild(agents));
}

}  // namespace
}  // namespace restenosis
