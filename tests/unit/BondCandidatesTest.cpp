#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "tissue/agents/BondCandidates.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

/// What connectNearestFirst is said to do, one candidate after the other.
std::size_t connectOneByOne(BondTable& bonds, std::vector<BondCandidate> candidates) {
  std::ranges::sort(candidates, {}, [](const BondCandidate& pair) {
    return std::tuple(pair.distance, std::min(pair.a, pair.b), std::max(pair.a, pair.b));
  });
  std::size_t made = 0;
  for (const BondCandidate& pair : candidates) made += bonds.connect(pair.a, pair.b, pair.distance);
  return made;
}

TEST(BondCandidates, AreConnectedNearestFirstWhoeverHasRoomForAll) {
  RandomStream random(7, 0, 0, RandomPurpose::packing);
  const auto below = [&](Index limit) { return static_cast<Index>(random.uniform() * limit); };
  // Few candidates for each, far more than there is room for, and some of both; some are given twice
  for (const double perAgent : {0.5, 4.0, 7.0, 20.0}) {
    AgentStore agents;
    for (int k = 0; k < 200; ++k) agents.append(AgentKind::smc, Vec3::Zero(), 1e-5);
    BondTable expected;
    expected.resize(agents.size());
    for (Index i = 0; i < 30; ++i) expected.connect(i, i + 50, 1e-5);
    BondTable bonds = expected;
    std::vector<BondCandidate> candidates;
    while (static_cast<double>(candidates.size()) < perAgent * agents.size()) {
      const Index a = below(agents.size()), b = below(agents.size());
      if (a == b) continue;
      candidates.push_back({(11 + a * b % 41) * 1e-6, a, b});
      if (below(10) == 0) candidates.push_back({candidates.back().distance, b, a});
    }
    const std::size_t made = connectNearestFirst(agents, bonds, candidates);
    EXPECT_EQ(made, connectOneByOne(expected, candidates)) << perAgent;
    for (Index i = 0; i < agents.size(); ++i) {
      ASSERT_EQ(bonds.of(i).size(), expected.of(i).size()) << perAgent << ", agent " << i;
      for (std::size_t n = 0; n < bonds.of(i).size(); ++n) {
        EXPECT_EQ(bonds.of(i)[n].partner, expected.of(i)[n].partner);
        EXPECT_EQ(bonds.of(i)[n].restLength, expected.of(i)[n].restLength);
      }
    }
  }
}

TEST(BondCandidates, WithinEachOtherAreNotBonded) {
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3::Zero(), 1e-5);
  agents.append(AgentKind::smc, Vec3::Zero(), 3e-5);
  BondTable bonds;
  bonds.resize(2);
  EXPECT_EQ(connectNearestFirst(agents, bonds, {{1.99e-5, 0, 1}}), 0u);
  EXPECT_EQ(connectNearestFirst(agents, bonds, {{2.01e-5, 0, 1}}), 1u);
}

}  // namespace
}  // namespace restenosis
