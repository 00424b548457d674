#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/forces/PairRows.h"

namespace restenosis {
namespace {

using namespace support;

/// Cells at random, some of them daughters, with bonds across and beyond the list's range.
struct Tissue {
  AgentStore agents;
  BondTable bonds;
  NeighbourList list;

  explicit Tissue(int count, const NeighbourRange& range = {.factor = 1, .daughterFactor = 1.3, .skin = r}) {
    RandomStream random(3, 0, 0, RandomPurpose::packing);
    const double side = 1.8 * r * std::cbrt(count);
    for (int k = 0; k < count; ++k) {
      const Vec3 place(random.uniform(), random.uniform(), random.uniform());
      agents.append(AgentKind::smc, side * place, r);
    }
    for (Index i = 5; i < agents.size(); i += 19) agents.set(i, AgentFlag::daughter, true);
    bonds.resize(agents.size());
    for (Index i = 0; i + 3 < agents.size(); i += 2) bonds.connect(i, i + 3, r);
    list.build(agents, range);
  }
  Index nobody() const { return agents.size() + 7; }
  PairSource source() const { return {list, bonds, agents.flags, true}; }
};

using Row = std::vector<std::pair<Index, float>>;

/// Partners of the agent that is the n-th in the order of the groups, with the rest lengths of their bonds.
Row rowAt(const PairRows& rows, std::size_t n, Index nobody) {
  Row row;
  bool ended = false;
  const std::size_t group = n / PairRows::width, lane = n % PairRows::width;
  const auto partners = rows.partners(group);
  const auto rests = rows.rests(group);
  const bool allMarked = rows.kind(group) == PairRows::Kind::marked;
  EXPECT_EQ(rests.size(), allMarked ? 0 : partners.size());
  for (std::size_t line = 0; line < partners.size(); ++line) {
    const Index partner = partners[line].agent[lane];
    ended |= partner == nobody;
    EXPECT_EQ(ended, partner == nobody) << "a partner behind the end of the row";
    if (!ended) row.emplace_back(partner, allMarked ? -INFINITY : rests[line].length[lane]);
    if (ended && !allMarked) {
      EXPECT_EQ(rests[line].length[lane], INFINITY);
    }
  }
  return row;
}

Row rowOf(const PairRows& rows, std::size_t k, Index nobody) {
  for (std::size_t n = 0; n < rows.size(); ++n)
    if (rows[n] == k) return rowAt(rows, n, nobody);
  ADD_FAILURE() << "no row of agent " << k;
  return {};
}

Row expectedRow(const Tissue& tissue, Index i) {
  Row row;
  for (Index j = 0; j < tissue.agents.size(); ++j) {
    const bool listed = std::ranges::count(tissue.list.of(i), j) > 0, bonded = tissue.bonds.bonded(i, j);
    if (!listed && !bonded) continue;
    const bool daughter =
        tissue.agents.has(i, AgentFlag::daughter) || tissue.agents.has(j, AgentFlag::daughter);
    const float rest = bonded ? static_cast<float>(r) : INFINITY;
    row.emplace_back(j, daughter ? -rest : rest);
  }
  return row;
}

std::vector<Index> everySecond(const Tissue& tissue) {
  std::vector<Index> agents;
  for (Index i = 0; i < tissue.agents.size(); i += 2) agents.push_back(i);
  return agents;
}

TEST(PairRows, HoldNeighboursAndBondPartnersOnceEachInAscendingOrder) {
  const Tissue tissue(403);
  const std::vector<Index> agents = everySecond(tissue);  // the last group has free lanes
  PairRows rows;
  rows.layOut(tissue.source(), agents, tissue.nobody());
  ASSERT_EQ(rows.size(), agents.size());
  for (std::size_t k = 0; k < agents.size(); ++k)
    EXPECT_EQ(rowOf(rows, k, tissue.nobody()), expectedRow(tissue, agents[k])) << k;
  ASSERT_NE(agents.size() % PairRows::width, 0U);
  for (std::size_t n = agents.size(); n < rows.groups() * PairRows::width; ++n)
    EXPECT_TRUE(rowAt(rows, n, tissue.nobody()).empty()) << n;
}

TEST(PairRows, StandByKindThenByLengthThenByPlace) {
  Tissue tissue(512);
  const double largest = *std::ranges::max_element(tissue.agents.x);
  for (Index i = 0; i < tissue.agents.size(); ++i) {
    if (tissue.agents.x[i] < 0.7 * largest) continue;
    tissue.bonds.disconnectAll(i);
    tissue.agents.set(i, AgentFlag::daughter, true);
  }
  tissue.list.build(tissue.agents, {.factor = 1, .daughterFactor = 1.3, .skin = r});
  const std::vector<Index> agents = everySecond(tissue);
  ASSERT_EQ(agents.size(), PairRows::most);
  PairRows rows;
  rows.layOut(tissue.source(), agents, tissue.nobody());
  using Kind = PairRows::Kind;
  using Key = std::tuple<Kind, std::size_t, std::size_t>;
  std::vector<Key> keys;
  std::map<Kind, std::size_t> count;
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const Row row = expectedRow(tissue, agents[k]);
    const bool anyMarked = std::ranges::any_of(row, [](const auto& pair) { return pair.second < 0; });
    const bool allMarked =
        tissue.agents.has(agents[k], AgentFlag::daughter) &&
        std::ranges::all_of(row, [](const auto& pair) { return pair.second == -INFINITY; });
    const Kind kind = allMarked ? Kind::marked : anyMarked ? Kind::mixed : Kind::unmarked;
    keys.emplace_back(kind, row.size(), k);
    ++count[kind];
  }
  std::ranges::sort(keys);
  for (const Kind kind : {Kind::unmarked, Kind::mixed, Kind::marked})
    ASSERT_GT(count[kind], PairRows::width) << static_cast<int>(kind);
  for (std::size_t n = 0; n < keys.size(); ++n) EXPECT_EQ(rows[n], std::get<2>(keys[n])) << n;
  for (std::size_t g = 0; g < rows.groups(); ++g) {
    const std::size_t first = g * PairRows::width;
    std::size_t longest = 0;
    for (std::size_t n = first; n < first + PairRows::width; ++n)
      longest = std::max(longest, std::get<1>(keys[n]));
    EXPECT_EQ(rows.partners(g).size(), longest) << g;
    const Kind lowest = std::get<0>(keys[first]), highest = std::get<0>(keys[first + PairRows::width - 1]);
    EXPECT_EQ(rows.kind(g), lowest == highest ? lowest : Kind::mixed) << g;
  }
}

TEST(PairRows, HoldRowsOfAnyLength) {
  AgentStore agents;
  for (int k = 0; k < 100; ++k) agents.append(AgentKind::smc, Vec3::Zero(), r);
  agents.append(AgentKind::smc, Vec3(10 * r, 0, 0), r);
  BondTable bonds;
  bonds.resize(agents.size());
  NeighbourList list;
  list.build(agents, {});
  std::vector<Index> all(agents.size());
  std::iota(all.begin(), all.end(), Index{0});
  PairRows rows;
  rows.layOut({list, bonds, agents.flags, true}, all, agents.size());
  EXPECT_EQ(rowOf(rows, 100, agents.size()).size(), 0U);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(rowOf(rows, k, agents.size()).size(), 99U);
}

TEST(PairRows, AreReplacedWhereThereIsRoom) {
  Tissue tissue(300);
  const std::vector<Index> agents = everySecond(tissue);
  PairRows rows;
  rows.layOut(tissue.source(), agents, tissue.nobody());
  // Each cell in turn goes to where another one is, and its row and those of the others change
  RandomStream random(4, 0, 0, RandomPurpose::packing);
  int replaced = 0, refused = 0;
  for (Index i = 0; i < tissue.agents.size(); i += 7) {
    const auto j = static_cast<Index>(random.uniform() * tissue.agents.size());
    tissue.agents.setPosition(i, tissue.agents.position(j) + 0.3 * r * random.direction());
    const std::vector<Index> moved{i};
    const NeighbourList::Change change = tissue.list.update(tissue.agents, moved);
    bool all = !change.all;  // the list is built anew now and then
    for (const Index c : change.agents) {
      const auto at = std::ranges::find(agents, c);
      if (at == agents.end()) continue;
      const bool done = rows.replace(tissue.source(), static_cast<std::size_t>(at - agents.begin()), c);
      done ? ++replaced : ++refused;
      all &= done;
    }
    if (!all) rows.layOut(tissue.source(), agents, tissue.nobody());
    for (std::size_t k = 0; k < agents.size(); ++k)
      ASSERT_EQ(rowOf(rows, k, tissue.nobody()), expectedRow(tissue, agents[k])) << i << ' ' << k;
  }
  EXPECT_GT(replaced, 100);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace restenosis
