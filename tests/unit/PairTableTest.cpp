#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>
#include <vector>

#include "Constants.h"
#include "PairTable.h"
#include "RandomStream.h"

namespace restenosis {
namespace {

using namespace support;

constexpr bool daughtersMarked = true;

/// Partners of an agent with the rest lengths of its bonds, without the padding.
std::vector<std::pair<Index, float>> partners(const PairTable& table, Index i) {
  std::vector<std::pair<Index, float>> row;
  for (std::uint32_t n = 0; n < table.length(i); ++n) {
    const PairTable::Block& block = table.row(i)[n / PairTable::width];
    const Index partner = block.partner[n % PairTable::width];
    if (partner != table.nobody()) row.emplace_back(partner, block.rest[n % PairTable::width]);
  }
  return row;
}

struct Tissue {
  AgentStore agents;
  BondTable bonds;
  NeighbourList list;

  explicit Tissue(int count) {
    RandomStream random(3, 0, 0, RandomPurpose::packing);
    const double side = 1.8 * r * std::cbrt(count);
    for (int k = 0; k < count; ++k) {
      const Vec3 place(random.uniform(), random.uniform(), random.uniform());
      agents.append(AgentKind::smc, side * place, r);
    }
    bonds.resize(agents.size());
    for (Index i = 0; i + 3 < agents.size(); i += 2) bonds.connect(i, i + 3, r);
  }
};

TEST(PairTable, HoldsNeighboursAndBondPartnersOnceEachInAscendingOrder) {
  Tissue tissue(203);
  tissue.agents.set(5, AgentFlag::daughter, true);
  tissue.list.build(tissue.agents, {.skin = r});
  PairTable table;
  table.build(tissue.list, tissue.bonds, tissue.agents.flags, daughtersMarked);
  for (Index i = 0; i < tissue.agents.size(); ++i) {
    std::vector<std::pair<Index, float>> expected;
    for (Index j = 0; j < tissue.agents.size(); ++j) {
      const bool listed = std::ranges::count(tissue.list.of(i), j) > 0, bonded = tissue.bonds.bonded(i, j);
      if (!listed && !bonded) continue;
      const float rest = bonded ? static_cast<float>(r) : INFINITY;
      expected.emplace_back(j, i == 5 || j == 5 ? -rest : rest);
    }
    ASSERT_EQ(partners(table, i), expected) << i;
  }
  EXPECT_TRUE(table.marked(5));
  const auto marked = [&](Index i) { return table.marked(i); };
  EXPECT_EQ(std::ranges::count_if(std::views::iota(Index{0}, tissue.agents.size()), marked),
            static_cast<std::ptrdiff_t>(partners(table, 5).size()) + 1);
}

TEST(PairTable, UpdatedIsWhatItWouldBeBuiltAnew) {
  Tissue tissue(1500);
  const NeighbourRange range{.factor = 1, .daughterFactor = 1.3, .skin = 0.4 * r};
  tissue.list.update(tissue.agents, range);
  PairTable updated;
  updated.build(tissue.list, tissue.bonds, tissue.agents.flags, daughtersMarked);
  Index nobody = updated.nobody();
  RandomStream random(4, 0, 0, RandomPurpose::packing);
  int updates = 0;
  for (int step = 0; step < 40; ++step) {
    for (Index i = static_cast<Index>(step); i < tissue.agents.size(); i += 97)
      tissue.agents.setPosition(i, tissue.agents.position(i) + 2 * r * random.direction());
    tissue.agents.append(AgentKind::smc, tissue.agents.position(static_cast<Index>(step)), r);
    tissue.bonds.resize(tissue.agents.size());
    const auto change = tissue.list.update(tissue.agents, range);
    PairTable anew;
    anew.build(tissue.list, tissue.bonds, tissue.agents.flags, daughtersMarked);
    if (change.all) {
      updated = anew;
      nobody = updated.nobody();
      continue;
    }
    ++updates;
    updated.update(tissue.list, tissue.bonds, tissue.agents.flags, daughtersMarked, change.agents);
    ASSERT_EQ(updated.nobody(), nobody);  // who holds spheres up to it need not change them
    ASSERT_GE(nobody, tissue.agents.size());
    for (Index i = 0; i < tissue.agents.size(); ++i)
      ASSERT_EQ(partners(updated, i), partners(anew, i)) << step << ' ' << i;
  }
  EXPECT_GT(updates, 30);
}

}  // namespace
}  // namespace restenosis
