#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "AlikeRows.h"
#include "Constants.h"
#include "RandomStream.h"

namespace restenosis {
namespace {

using namespace support;

TEST(AlikeRows, OrdersByDaughtersThenByLengthThenByPlace) {
  AgentStore agents;
  RandomStream random(3, 0, 0, RandomPurpose::packing);
  for (Index k = 0; k < AlikeRows::most; ++k) {
    const Vec3 place(random.uniform(), random.uniform(), random.uniform());
    agents.append(AgentKind::smc, 12 * r * place, r);
    agents.set(k, AgentFlag::daughter, k % 19 == 0);
  }
  NeighbourList list;
  list.build(agents, {.factor = 1.3});
  BondTable bonds;
  bonds.resize(agents.size());
  PairTable pairs;
  pairs.build(list, bonds, agents.flags, true);
  std::vector<Index> piece(AlikeRows::most);
  std::iota(piece.rbegin(), piece.rend(), Index{0});
  const AlikeRows order(pairs, piece);

  using Key = std::tuple<bool, std::uint32_t, std::size_t>;
  std::vector<Key> keys;
  for (std::size_t k = 0; k < piece.size(); ++k)
    keys.emplace_back(pairs.marked(piece[k]), pairs.length(piece[k]), k);
  const auto [shortest, longest] = std::minmax_element(keys.begin(), keys.end());
  ASSERT_FALSE(std::get<bool>(*shortest));
  ASSERT_TRUE(std::get<bool>(*longest));
  ASSERT_LT(pairs.length(piece[std::get<std::size_t>(*longest)]), 63U);
  std::ranges::sort(keys);
  for (std::size_t n = 0; n < keys.size(); ++n) EXPECT_EQ(order[n], std::get<std::size_t>(keys[n]));
}

TEST(AlikeRows, LeavesRowsBeyondSixtyTwoAsTheyStand) {
  AgentStore agents;
  for (int k = 0; k < 100; ++k) agents.append(AgentKind::smc, Vec3::Zero(), r);
  agents.append(AgentKind::smc, Vec3(10 * r, 0, 0), r);
  NeighbourList list;
  list.build(agents, {});
  BondTable bonds;
  bonds.resize(agents.size());
  PairTable pairs;
  pairs.build(list, bonds, agents.flags, true);
  const std::vector<Index> piece{5, 3, 100, 4};
  const AlikeRows order(pairs, piece);
  EXPECT_EQ(order[0], 2U);
  EXPECT_EQ(order[1], 0U);
  EXPECT_EQ(order[2], 1U);
  EXPECT_EQ(order[3], 3U);
}

}  // namespace
}  // namespace restenosis
