#include "tissue/agents/BondTable.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace restenosis {
namespace {

// A list without capacity left gets it for so many bonds.
constexpr std::uint32_t moreCapacity = 4;

/// The order of the bonds of an agent.
bool before(const Bond& a, const Bond& b) { return a.partner < b.partner; }

}  // namespace

bool BondTable::bonded(Index a, Index b) const {
  return std::ranges::any_of(of(a), [b](const Bond& bond) { return bond.partner == b; });
}

bool BondTable::connect(Index a, Index b, double restLength) {
  assert(a != b);
  if (of(a).size() == maxBonds || of(b).size() == maxBonds || bonded(a, b)) return false;
  insert(a, {b, static_cast<float>(restLength)});
  insert(b, {a, static_cast<float>(restLength)});
  return true;
}

void BondTable::disconnect(Index a, Index b) {
  remove(a, b);
  remove(b, a);
}

void BondTable::disconnectAll(Index agent) {
  while (!of(agent).empty()) disconnect(agent, of(agent).front().partner);
}

void BondTable::reorder(std::span<const Index> order) {
  std::vector<Index> newIndex(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) newIndex[order[k]] = static_cast<Index>(k);
  select(order, newIndex);
}

void BondTable::erase(std::span<const std::uint8_t> remove) {
  for (Index i = 0; i < size(); ++i) {
    if (remove[i]) disconnectAll(i);
  }
  std::vector<Index> newIndex(size(), std::numeric_limits<Index>::max()), kept;
  for (Index i = 0; i < size(); ++i) {
    if (remove[i]) continue;
    newIndex[i] = static_cast<Index>(kept.size());
    kept.push_back(i);
  }
  select(kept, newIndex);
}

void BondTable::select(std::span<const Index> agents, std::span<const Index> newIndex) {
  JaggedArray<Bond> lists;
  lists.layOut(agents.size(), [&](std::size_t k) { return of(agents[k]).size(); });
  for (std::size_t k = 0; k < agents.size(); ++k) {
    std::ranges::transform(of(agents[k]), lists[k].begin(), [&](const Bond& bond) {
      return Bond{.partner = newIndex[bond.partner], .restLength = bond.restLength};
    });
    std::ranges::sort(lists[k], before);
  }
  lists_ = std::move(lists);
}

void BondTable::insert(Index agent, Bond bond) {
  if (lists_.wasteful()) lists_.compact();
  const auto bonds = of(agent);
  const auto position = std::ranges::upper_bound(bonds, bond, before) - bonds.begin();
  lists_.insert(agent, static_cast<std::size_t>(position), bond, moreCapacity - 1);
}

void BondTable::remove(Index agent, Index partner) {
  const auto bonds = of(agent);
  const auto position = std::ranges::find(bonds, partner, &Bond::partner) - bonds.begin();
  if (position < std::ssize(bonds)) lists_.erase(agent, static_cast<std::size_t>(position));
}

}  // namespace restenosis
