#include "BondTable.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

#include "Room.h"

namespace restenosis {

std::size_t BondTable::bondCount() const {
  return std::accumulate(count_.begin(), count_.end(), std::size_t{0}) / 2;
}

void BondTable::resize(Index agents) {
  makeRoom(bonds_, agents);
  makeRoom(count_, agents);
  bonds_.resize(agents);
  count_.resize(agents, 0);
}

bool BondTable::bonded(Index a, Index b) const {
  return std::ranges::any_of(of(a), [b](const Bond& bond) { return bond.partner == b; });
}

bool BondTable::connect(Index a, Index b, double restLength) {
  assert(a != b);
  if (count_[a] == maxBonds || count_[b] == maxBonds || bonded(a, b)) return false;
  insert(a, {b, static_cast<float>(restLength)});
  insert(b, {a, static_cast<float>(restLength)});
  return true;
}

void BondTable::disconnect(Index a, Index b) {
  remove(a, b);
  remove(b, a);
}

void BondTable::disconnectAll(Index agent) {
  while (count_[agent] > 0) disconnect(agent, bonds_[agent][0].partner);
}

void BondTable::reorder(std::span<const Index> order) {
  std::vector<Index> newIndex(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) newIndex[order[k]] = static_cast<Index>(k);
  const auto oldBonds = std::exchange(bonds_, std::vector<std::array<Bond, maxBonds>>(order.size()));
  const auto oldCount = count_;
  for (std::size_t k = 0; k < order.size(); ++k) {
    count_[k] = oldCount[order[k]];
    bonds_[k] = oldBonds[order[k]];
    for (std::size_t n = 0; n < count_[k]; ++n) bonds_[k][n].partner = newIndex[bonds_[k][n].partner];
    std::sort(bonds_[k].begin(), bonds_[k].begin() + count_[k],
              [](const Bond& a, const Bond& b) { return a.partner < b.partner; });
  }
}

void BondTable::erase(std::span<const std::uint8_t> remove) {
  for (Index i = 0; i < size(); ++i) {
    if (remove[i]) disconnectAll(i);
  }
  std::vector<Index> newIndex(size(), std::numeric_limits<Index>::max());
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    if (!remove[i]) newIndex[i] = kept++;
  }
  for (Index i = 0; i < size(); ++i) {
    if (remove[i]) continue;
    const Index k = newIndex[i];
    count_[k] = count_[i];
    bonds_[k] = bonds_[i];
    for (std::size_t n = 0; n < count_[k]; ++n) bonds_[k][n].partner = newIndex[bonds_[k][n].partner];
  }
  resize(kept);
}

void BondTable::insert(Index agent, Bond bond) {
  auto& list = bonds_[agent];
  std::size_t n = count_[agent]++;
  for (; n > 0 && list[n - 1].partner > bond.partner; --n) list[n] = list[n - 1];
  list[n] = bond;
}

void BondTable::remove(Index agent, Index partner) {
  auto& list = bonds_[agent];
  const auto end = list.begin() + count_[agent];
  const auto last = std::remove_if(list.begin(), end, [&](const Bond& b) { return b.partner == partner; });
  count_[agent] = static_cast<std::uint8_t>(last - list.begin());
}

}  // namespace restenosis
