#include "tissue/agents/BondTable.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace restenosis {
namespace {

// Rows get room for so many bonds at a time.
constexpr std::uint32_t moreRoom = 4;

/// Which bonds come first in a row.
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
  take(order, newIndex);
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
  take(kept, newIndex);
}

void BondTable::take(std::span<const Index> agents, std::span<const Index> newIndex) {
  RowPool<Bond> rows;
  rows.layOut(agents.size(), [&](std::size_t k) { return of(agents[k]).size(); });
  for (std::size_t k = 0; k < agents.size(); ++k) {
    std::ranges::transform(of(agents[k]), rows[k].begin(), [&](const Bond& bond) {
      return Bond{.partner = newIndex[bond.partner], .restLength = bond.restLength};
    });
    std::ranges::sort(rows[k], before);
  }
  rows_ = std::move(rows);
}

void BondTable::insert(Index agent, Bond bond) {
  if (rows_.wasteful()) rows_.compact();
  rows_.append(agent, bond, moreRoom - 1);
  const std::span<Bond> row = rows_[agent];
  std::rotate(std::upper_bound(row.begin(), row.end() - 1, bond, before), row.end() - 1, row.end());
}

void BondTable::remove(Index agent, Index partner) {
  const std::span<Bond> row = rows_[agent];
  const auto removed = std::ranges::remove(row, partner, &Bond::partner);
  rows_.shorten(agent, row.size() - removed.size());
}

}  // namespace restenosis
