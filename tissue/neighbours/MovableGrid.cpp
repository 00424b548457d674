#include "tissue/neighbours/MovableGrid.h"

#include <algorithm>

#include "tissue/agents/Capacity.h"

namespace restenosis {
namespace {

// A bucket has room for so many more points, and gets this much when it has none.
constexpr std::uint32_t spare = 1, moreRoom = 4;

}  // namespace

void MovableGrid::fill() {
  std::vector<std::uint32_t> left(lattice_.cellCount());
  for (const std::uint32_t cell : cell_) ++left[cell];
  buckets_.layOut(
      left.size(), [&](std::size_t cell) { return left[cell]; }, spare);
  for (Index i = 0; i < size(); ++i) {
    const std::span<Entry> bucket = buckets_[cell_[i]];
    bucket[bucket.size() - left[cell_[i]]--].point = i;
  }
}

void MovableGrid::take(const Move& move) {
  const Index i = move.entry.point;
  if (i == size()) {
    growCapacity(cell_, cell_.size() + 1);
    cell_.push_back(move.cell);
  } else {
    entryOf(i) = buckets_[cell_[i]].back();
    buckets_.shorten(cell_[i], buckets_[cell_[i]].size() - 1);
    cell_[i] = move.cell;
  }
  if (buckets_.wasteful()) buckets_.compact(spare);
  buckets_.append(move.cell, move.entry, moreRoom);
}

}  // namespace restenosis
