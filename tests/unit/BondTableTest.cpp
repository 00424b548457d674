#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tissue/agents/BondTable.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

BondTable bondsOf(Index agents, const std::vector<std::pair<Index, Index>>& pairs) {
  BondTable bonds;
  bonds.resize(agents);
  // The rest length tells which bond it is, whatever the agents are called.
  for (std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_TRUE(bonds.connect(pairs[k].first, pairs[k].second, static_cast<double>(k + 1)));
  return bonds;
}

/// Partners and rest lengths of an agent's bonds.
std::vector<std::pair<Index, float>> heldBy(const BondTable& bonds, Index agent) {
  std::vector<std::pair<Index, float>> held;
  for (const Bond& bond : bonds.of(agent)) held.emplace_back(bond.partner, bond.restLength);
  return held;
}

using Held = std::vector<std::pair<Index, float>>;

TEST(BondTable, HoldsEveryBondAtBothEndsSortedByPartner) {
  const BondTable bonds = bondsOf(4, {{2, 3}, {2, 0}, {1, 2}});
  EXPECT_EQ(bonds.bondCount(), 3u);
  EXPECT_EQ(heldBy(bonds, 2), (Held{{0, 2}, {1, 3}, {3, 1}}));
  EXPECT_EQ(heldBy(bonds, 0), (Held{{2, 2}}));
  EXPECT_TRUE(bonds.bonded(0, 2) && bonds.bonded(2, 0));
  EXPECT_FALSE(bonds.bonded(0, 1) || bonds.bonded(1, 0));
}

TEST(BondTable, ABondThatIsThereIsNotMadeAgain) {
  BondTable bonds = bondsOf(2, {{0, 1}});
  EXPECT_FALSE(bonds.connect(0, 1, 7));
  EXPECT_FALSE(bonds.connect(1, 0, 7));
  EXPECT_EQ(heldBy(bonds, 0), (Held{{1, 1}}));
}

TEST(BondTable, TheThirteenthBondIsRefusedFromEitherEnd) {
  BondTable bonds;
  bonds.resize(14);
  for (Index other = 1; other <= 12; ++other) EXPECT_TRUE(bonds.connect(0, other, 1));
  EXPECT_FALSE(bonds.connect(0, 13, 1));
  EXPECT_FALSE(bonds.connect(13, 0, 1));
  EXPECT_EQ(bonds.of(0).size(), 12u);
  EXPECT_TRUE(bonds.of(13).empty());
  EXPECT_EQ(bonds.bondCount(), 12u);

  bonds.disconnect(5, 0);
  EXPECT_TRUE(bonds.connect(13, 0, 1)) << "there is room again";
}

TEST(BondTable, DisconnectTakesBothEndsAndNothingElse) {
  BondTable bonds = bondsOf(4, {{0, 1}, {0, 2}, {1, 2}, {2, 3}});
  bonds.disconnect(2, 0);
  EXPECT_EQ(heldBy(bonds, 0), (Held{{1, 1}}));
  EXPECT_EQ(heldBy(bonds, 2), (Held{{1, 3}, {3, 4}}));
  bonds.disconnect(0, 3);  // never bonded
  EXPECT_EQ(bonds.bondCount(), 3u);

  bonds.disconnectAll(2);
  EXPECT_TRUE(bonds.of(2).empty());
  EXPECT_TRUE(bonds.of(3).empty());
  EXPECT_EQ(heldBy(bonds, 1), (Held{{0, 1}}));
}

TEST(BondTable, EraseRenumbersThePartnersThatStay) {
  BondTable bonds = bondsOf(5, {{0, 4}, {0, 2}, {2, 4}, {1, 3}, {3, 4}});
  const std::vector<std::uint8_t> remove = {0, 1, 0, 1, 0};
  bonds.erase(remove);
  // 0, 2 and 4 are now 0, 1 and 2.
  ASSERT_EQ(bonds.size(), 3u);
  EXPECT_EQ(heldBy(bonds, 0), (Held{{1, 2}, {2, 1}}));
  EXPECT_EQ(heldBy(bonds, 1), (Held{{0, 2}, {2, 3}}));
  EXPECT_EQ(heldBy(bonds, 2), (Held{{0, 1}, {1, 3}}));
  EXPECT_EQ(bonds.bondCount(), 3u);
}

TEST(BondTable, ReorderRenumbersAndSortsAgain) {
  BondTable bonds = bondsOf(4, {{0, 1}, {0, 2}, {0, 3}, {2, 3}});
  const std::vector<Index> order = {3, 0, 1, 2};  // 0, 1, 2, 3 become 1, 2, 3, 0
  bonds.reorder(order);
  EXPECT_EQ(heldBy(bonds, 0), (Held{{1, 3}, {3, 4}}));
  EXPECT_EQ(heldBy(bonds, 1), (Held{{0, 3}, {2, 1}, {3, 2}}));
  EXPECT_EQ(heldBy(bonds, 2), (Held{{1, 1}}));
  EXPECT_EQ(heldBy(bonds, 3), (Held{{0, 4}, {1, 2}}));
}

TEST(BondTable, NewAgentsHaveNoBonds) {
  BondTable bonds = bondsOf(2, {{0, 1}});
  bonds.erase(std::vector<std::uint8_t>{0, 1});
  bonds.resize(3);
  for (Index i = 0; i < 3; ++i) EXPECT_TRUE(bonds.of(i).empty()) << i;
  EXPECT_EQ(bonds.bondCount(), 0u);
}

TEST(BondTable, HoldsWhatItShouldAfterManyChanges) {
  constexpr Index count = 3000;
  BondTable bonds;
  bonds.resize(count);
  std::vector<std::map<Index, float>> expected(count);
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  const auto any = [&] { return static_cast<Index>(random.uniform() * count); };
  for (int change = 0; change < 60000; ++change) {
    const Index a = any(), b = any();
    if (a == b) continue;
    if (change % 5 == 0) {
      bonds.disconnectAll(a);
      for (const auto& [partner, rest] : expected[a]) expected[partner].erase(a);
      expected[a].clear();
    } else {
      const bool possible = !expected[a].contains(b) && expected[a].size() < BondTable::maxBonds &&
                            expected[b].size() < BondTable::maxBonds;
      ASSERT_EQ(bonds.connect(a, b, change), possible);
      if (possible) expected[a][b] = expected[b][a] = static_cast<float>(change);
    }
  }
  std::vector<Index> order(count);
  for (Index k = 0; k < count; ++k) order[k] = count - 1 - k;
  bonds.reorder(order);
  std::size_t ends = 0;
  for (Index k = 0; k < count; ++k) {
    Held held;
    for (const auto& [partner, rest] : expected[order[k]]) held.emplace_back(count - 1 - partner, rest);
    std::ranges::sort(held);
    ASSERT_EQ(heldBy(bonds, k), held) << k;
    ends += held.size();
  }
  EXPECT_EQ(bonds.bondCount(), ends / 2);
  EXPECT_GT(ends, std::size_t{count});
}

}  // namespace
}  // namespace restenosis
