#include <gtest/gtest.h>

#include <algorithm>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/SpatialOrder.h"

namespace restenosis {
namespace {

AgentStore scattered(int count) {
  AgentStore agents;
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  for (int k = 0; k < count; ++k) {
    agents.append(AgentKind::smc, 1e-4 * Vec3(random.uniform(), random.uniform(), random.uniform()), 1e-6);
  }
  return agents;
}

TEST(SpatialOrder, IsAPermutationThatBringsNeighboursTogether) {
  const AgentStore agents = scattered(4000);
  const auto order = spatialOrder(agents);
  auto sorted = order;
  std::ranges::sort(sorted);
  for (Index k = 0; k < sorted.size(); ++k) ASSERT_EQ(sorted[k], k);
  double before = 0, after = 0;
  for (Index k = 1; k < agents.size(); ++k) {
    before += (agents.position(k) - agents.position(k - 1)).norm();
    after += (agents.position(order[k]) - agents.position(order[k - 1])).norm();
  }
  EXPECT_LT(after, 0.25 * before);
}

TEST(SpatialOrder, DependsOnPositionsAndIdsOnly) {
  AgentStore agents = scattered(500), shuffled = agents;
  std::vector<Index> reversed(agents.size());
  for (Index k = 0; k < agents.size(); ++k) reversed[k] = agents.size() - 1 - k;
  shuffled.reorder(reversed);
  agents.reorder(spatialOrder(agents));
  shuffled.reorder(spatialOrder(shuffled));
  EXPECT_EQ(agents.id, shuffled.id);
}

}  // namespace
}  // namespace restenosis
