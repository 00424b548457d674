#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/forces/PairList.h"

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
  Index none() const { return agents.size() + 7; }
  PairSource source() const { return {list, bonds, agents.flags, true}; }
};

using List = std::vector<std::pair<Index, float>>;

/// Partners of the agent that is the n-th in the order of the slices, with the rest lengths of their bonds.
List listAt(const PairList& pairs, std::size_t n, Index none) {
  List list;
  bool ended = false;
  const std::size_t lane = n % PairList::width;
  for (const PairList::Entry& entry : pairs.entries(n / PairList::width)) {
    ended |= entry.partner[lane] == none;
    EXPECT_EQ(ended, entry.partner[lane] == none) << "a partner behind the end of the list";
    if (!ended) list.emplace_back(entry.partner[lane], entry.restLength[lane]);
    if (ended) {
      EXPECT_EQ(entry.restLength[lane], INFINITY);
    }
  }
  return list;
}

List listOf(const PairList& pairs, std::size_t k, Index none) {
  for (std::size_t n = 0; n < pairs.size(); ++n)
    if (pairs[n] == k) return listAt(pairs, n, none);
  ADD_FAILURE() << "no list of agent " << k;
  return {};
}

List expectedList(const Tissue& tissue, Index i) {
  List list;
  for (Index j = 0; j < tissue.agents.size(); ++j) {
    const bool listed = std::ranges::count(tissue.list.of(i), j) > 0, bonded = tissue.bonds.bonded(i, j);
    if (!listed && !bonded) continue;
    const bool daughter =
        tissue.agents.has(i, AgentFlag::daughter) || tissue.agents.has(j, AgentFlag::daughter);
    const float rest = bonded ? static_cast<float>(r) : INFINITY;
    list.emplace_back(j, daughter ? -rest : rest);
  }
  return list;
}

std::vector<Index> everySecond(const Tissue& tissue) {
  std::vector<Index> agents;
  for (Index i = 0; i < tissue.agents.size(); i += 2) agents.push_back(i);
  return agents;
}

TEST(PairList, HoldsNeighboursAndBondPartnersOnceEachInAscendingOrder) {
  const Tissue tissue(403);
  const std::vector<Index> agents = everySecond(tissue);  // the last slice has free lanes
  PairList pairs;
  pairs.build(tissue.source(), agents, tissue.none());
  ASSERT_EQ(pairs.size(), agents.size());
  for (std::size_t k = 0; k < agents.size(); ++k)
    EXPECT_EQ(listOf(pairs, k, tissue.none()), expectedList(tissue, agents[k])) << k;
  ASSERT_NE(agents.size() % PairList::width, 0U);
  for (std::size_t n = agents.size(); n < pairs.slices() * PairList::width; ++n)
    EXPECT_TRUE(listAt(pairs, n, tissue.none()).empty()) << n;
}

TEST(PairList, IsSortedByLengthThenByPlace) {
  const Tissue tissue(512);
  const std::vector<Index> agents = everySecond(tissue);
  ASSERT_EQ(agents.size(), PairList::capacity);
  PairList pairs;
  pairs.build(tissue.source(), agents, tissue.none());
  std::vector<std::pair<std::size_t, std::size_t>> keys;
  for (std::size_t k = 0; k < agents.size(); ++k)
    keys.emplace_back(expectedList(tissue, agents[k]).size(), k);
  std::ranges::sort(keys);
  for (std::size_t n = 0; n < keys.size(); ++n) EXPECT_EQ(pairs[n], keys[n].second) << n;
  for (std::size_t slice = 0; slice < pairs.slices(); ++slice) {
    const std::size_t last = slice * PairList::width + PairList::width - 1;
    EXPECT_EQ(pairs.entries(slice).size(), keys[last].first) << slice;
  }
}

TEST(PairList, SaysWhichSlicesHaveBondsAndWhichCohere) {
  const Tissue tissue(512);
  const std::vector<Index> agents = everySecond(tissue);
  PairList pairs;
  pairs.build(tissue.source(), agents, tissue.none());
  std::array<int, 2> bonded{}, cohering{};
  for (std::size_t slice = 0; slice < pairs.slices(); ++slice) {
    bool anyBond = false, anyCohesion = false;
    for (std::size_t n = slice * PairList::width; n < (slice + 1) * PairList::width; ++n) {
      for (const auto& [partner, rest] : listAt(pairs, n, tissue.none()))
        anyBond |= std::isfinite(rest), anyCohesion |= rest < 0;
    }
    EXPECT_EQ(pairs.attractions(slice).bonds, anyBond) << slice;
    EXPECT_EQ(pairs.attractions(slice).cohesion, anyCohesion) << slice;
    ++bonded[anyBond], ++cohering[anyCohesion];
  }
  EXPECT_GT(bonded[1], 0);
  EXPECT_GT(cohering[1], 0);
}

TEST(PairList, SaysThatASliceHasABondOnceOneIsListed) {
  Tissue tissue(40);
  tissue.bonds = {};
  tissue.bonds.resize(tissue.agents.size());
  for (Index i = 0; i < tissue.agents.size(); ++i) tissue.agents.set(i, AgentFlag::daughter, false);
  const std::vector<Index> agents{0, 1, 2};
  PairList pairs;
  pairs.build(tissue.source(), agents, tissue.none());
  EXPECT_FALSE(pairs.attractions(0).bonds || pairs.attractions(0).cohesion);
  tissue.bonds.connect(1, 30, r);
  tissue.agents.set(1, AgentFlag::daughter, true);
  ASSERT_TRUE(pairs.replace(tissue.source(), 1, 1));
  EXPECT_TRUE(pairs.attractions(0).bonds && pairs.attractions(0).cohesion);
}

TEST(PairList, HoldsListsOfAnyLength) {
  AgentStore agents;
  for (int k = 0; k < 100; ++k) agents.append(AgentKind::smc, Vec3::Zero(), r);
  agents.append(AgentKind::smc, Vec3(10 * r, 0, 0), r);
  BondTable bonds;
  bonds.resize(agents.size());
  NeighbourList list;
  list.build(agents, {});
  std::vector<Index> all(agents.size());
  std::iota(all.begin(), all.end(), Index{0});
  PairList pairs;
  pairs.build({list, bonds, agents.flags, true}, all, agents.size());
  EXPECT_EQ(listOf(pairs, 100, agents.size()).size(), 0U);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(listOf(pairs, k, agents.size()).size(), 99U);
}

TEST(PairList, IsBuiltAgainForOtherAgents) {
  const Tissue tissue(300);
  const std::vector<Index> many = everySecond(tissue), few{1, 3, 5};
  PairList pairs;
  for (const auto& agents : {many, few, many}) {
    pairs.build(tissue.source(), agents, tissue.none());
    for (std::size_t k = 0; k < agents.size(); ++k)
      EXPECT_EQ(listOf(pairs, k, tissue.none()), expectedList(tissue, agents[k])) << k;
  }
}

TEST(PairSource, MarksNoPairWithoutCohesion) {
  const Tissue tissue(100);
  PairSource source = tissue.source();
  source.cohesion = false;
  for (Index i = 0; i < tissue.agents.size(); ++i) {
    std::vector<Pair> pairs;
    source.append(i, pairs);
    List expected = expectedList(tissue, i);
    ASSERT_EQ(pairs.size(), expected.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      EXPECT_EQ(pairs[k].partner, expected[k].first);
      EXPECT_EQ(pairs[k].restLength, std::abs(expected[k].second));
    }
  }
}

}  // namespace
}  // namespace restenosis
