#include "BondTable.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "Room.h"

namespace restenosis {
namespace {

// Rows get room for so many bonds at a time.
constexpr std::uint16_t moreRoom = 4;
static_assert(BondTable::maxBonds % moreRoom == 0);
// When so many places, and this share of them, are abandoned, the rows are moved together.
constexpr std::size_t manyAbandoned = 4096;
constexpr double mostAbandoned = 0.25;

}  // namespace

std::size_t BondTable::bondCount() const {
  std::size_t ends = 0;
  for (const Row& row : rows_) ends += row.count;
  return ends / 2;
}

void BondTable::resize(Index agents) {
  makeRoom(rows_, agents);
  rows_.resize(agents);
}

bool BondTable::bonded(Index a, Index b) const {
  return std::ranges::any_of(of(a), [b](const Bond& bond) { return bond.partner == b; });
}

bool BondTable::connect(Index a, Index b, double restLength) {
  assert(a != b);
  if (rows_[a].count == maxBonds || rows_[b].count == maxBonds || bonded(a, b)) return false;
  insert(a, {b, static_cast<float>(restLength)});
  insert(b, {a, static_cast<float>(restLength)});
  return true;
}

void BondTable::disconnect(Index a, Index b) {
  remove(a, b);
  remove(b, a);
}

void BondTable::disconnectAll(Index agent) {
  while (rows_[agent].count > 0) disconnect(agent, of(agent).front().partner);
}

void BondTable::reorder(std::span<const Index> order) {
  std::vector<Index> newIndex(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) newIndex[order[k]] = static_cast<Index>(k);
  layOut(
      static_cast<Index>(order.size()), [&](Index k) { return order[k]; },
      [&](Index partner) { return newIndex[partner]; });
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
  layOut(
      static_cast<Index>(kept.size()), [&](Index k) { return kept[k]; },
      [&](Index partner) { return newIndex[partner]; });
}

template <class RowOf, class NameOf>
void BondTable::layOut(Index agents, RowOf&& rowOf, NameOf&& nameOf) {
  std::size_t ends = 0;
  for (Index k = 0; k < agents; ++k) ends += rows_[rowOf(k)].count;
  std::vector<Bond> bonds;
  makeRoom(bonds, ends);
  std::vector<Row> rows;
  makeRoom(rows, agents);
  for (Index k = 0; k < agents; ++k) {
    const std::size_t start = bonds.size();
    for (const Bond& bond : of(rowOf(k))) bonds.push_back({nameOf(bond.partner), bond.restLength});
    std::sort(bonds.begin() + static_cast<std::ptrdiff_t>(start), bonds.end(),
              [](const Bond& a, const Bond& b) { return a.partner < b.partner; });
    const auto count = static_cast<std::uint16_t>(bonds.size() - start);
    rows.push_back({.start = static_cast<std::uint32_t>(start), .count = count, .room = count});
  }
  bonds_ = std::move(bonds);
  rows_ = std::move(rows);
  abandoned_ = 0;
}

void BondTable::widen(Row& row) {
  if (bonds_.size() + maxBonds > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more bonds than four thousand million");
  const Row before = row;
  row.start = static_cast<std::uint32_t>(bonds_.size());
  row.room = static_cast<std::uint16_t>(std::min<std::size_t>(maxBonds, before.room + moreRoom));
  makeRoom(bonds_, bonds_.size() + row.room);
  bonds_.resize(bonds_.size() + row.room);
  std::copy_n(bonds_.begin() + before.start, before.count, bonds_.begin() + row.start);
  abandoned_ += before.room;
}

void BondTable::insert(Index agent, Bond bond) {
  if (rows_[agent].count == rows_[agent].room) {
    if (abandoned_ > manyAbandoned &&
        static_cast<double>(abandoned_) > mostAbandoned * static_cast<double>(bonds_.size()))
      layOut(size(), std::identity{}, std::identity{});
    widen(rows_[agent]);
  }
  Bond* const list = bonds_.data() + rows_[agent].start;
  std::size_t n = rows_[agent].count++;
  for (; n > 0 && list[n - 1].partner > bond.partner; --n) list[n] = list[n - 1];
  list[n] = bond;
}

void BondTable::remove(Index agent, Index partner) {
  const auto list = bonds_.begin() + rows_[agent].start;
  const auto last = std::remove_if(list, list + rows_[agent].count,
                                   [&](const Bond& bond) { return bond.partner == partner; });
  rows_[agent].count = static_cast<std::uint16_t>(last - list);
}

}  // namespace restenosis
