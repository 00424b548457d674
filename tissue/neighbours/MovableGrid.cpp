#include "MovableGrid.h"

#include <algorithm>

#include "Room.h"

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

void MovableGrid::place(Index i, const Vec3& point) {
  const std::uint32_t cell = lattice_.cellOf(point);
  const Entry entry{.place = scale_.of(point), .point = i};
  if (i == size()) {
    makeRoom(cell_, cell_.size() + 1);
    cell_.push_back(cell);
    add(entry, cell);
  } else if (cell != cell_[i]) {
    take(i);
    cell_[i] = cell;
    add(entry, cell);
  } else {
    entryOf(i) = entry;
  }
}

void MovableGrid::add(const Entry& entry, std::uint32_t cell) {
  if (buckets_.wasteful()) buckets_.compact(spare);
  buckets_.append(cell, entry, moreRoom);
}

void MovableGrid::take(Index i) {
  entryOf(i) = buckets_[cell_[i]].back();
  buckets_.shorten(cell_[i], buckets_[cell_[i]].size() - 1);
}

}  // namespace restenosis
