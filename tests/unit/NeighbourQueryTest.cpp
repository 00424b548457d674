#include <gtest/gtest.h>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/NeighbourQuery.h"

namespace restenosis {
namespace {

AgentStore ofMixedSizes(int count, double ratio) {
  AgentStore agents;
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  for (int k = 0; k < count; ++k) {
    const Vec3 place(random.uniform(), random.uniform(), random.uniform());
    agents.append(AgentKind::smc, 1e-4 * place, 1e-6 * std::pow(ratio, random.uniform()));
  }
  return agents;
}

TEST(NeighbourQuery, FindsWhoIsWithinAFactorOfTheRadiiInAscendingOrder) {
  const AgentStore agents = ofMixedSizes(300, 10);
  const CellGrid grid(agents, 5e-6);
  NeighbourQuery query(agents, grid);
  for (const double factor : {1.0, 2.0}) {
    for (Index i = 0; i < agents.size(); ++i) {
      std::vector<Index> expected, found;
      for (Index j = 0; j < agents.size(); ++j) {
        const double reach = factor * (agents.radius[i] + agents.radius[j]);
        if (i != j && (agents.position(i) - agents.position(j)).norm() <= reach) expected.push_back(j);
      }
      query.forEachNeighbour(i, factor, [&](Index j, double distance) {
        found.push_back(j);
        EXPECT_DOUBLE_EQ(distance, (agents.position(i) - agents.position(j)).norm());
      });
      ASSERT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace restenosis
