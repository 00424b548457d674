#include "tissue/neighbours/MovableGrid.h"

#include <algorithm>

#include "tissue/agents/Capacity.h"

namespace restenosis {
namespace {

// Capacity of a bucket for more points, at first and when it has none left.
constexpr std::uint32_t spare = 1, moreSpare = 4;

}  // namespace

void MovableGrid::fill() {
  std::vector<std::uint32_t> left(lattice_.cellCount());
  for (const std::uint32_t cell : cell_) ++left[cell];
  buckets_.layOut(
      left.size(), [&](std::size_t cell) { return left[cell]; }, spare);
  for (Index i = 0; i < size(); ++i) {
    const std::span<Index> bucket = buckets_[cell_[i]];
    bucket[bucket.size() - left[cell_[i]]--] = i;
  }
}

void MovableGrid::append(std::uint32_t cell, Index i) {
  if (buckets_.wasteful()) buckets_.compact(spare);
  buckets_.append(cell, i, moreSpare);
}

void MovableGrid::add(const Vec3& point) {
  growCapacity(cell_, cell_.size() + 1);
  cell_.push_back(lattice_.cellOf(point));
  append(cell_.back(), size() - 1);
}

void MovableGrid::move(Index i, const Vec3& point) {
  const std::uint32_t before = cell_[i], now = lattice_.cellOf(point);
  if (now == before) return;
  const std::span<const Index> bucket = buckets_[before];
  buckets_.erase(before, static_cast<std::size_t>(std::ranges::find(bucket, i) - bucket.begin()));
  cell_[i] = now;
  append(now, i);
}

}  // namespace restenosis
