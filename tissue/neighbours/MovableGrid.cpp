#include "MovableGrid.h"

#include <algorithm>

#include "Room.h"

namespace restenosis {
namespace {

// A bucket has room for so many more points, and gets this much when it has none.
constexpr std::uint32_t spare = 1, moreRoom = 4;
// When more than this share of the places is abandoned, the buckets are moved together.
constexpr double mostAbandoned = 0.25;

}  // namespace

void MovableGrid::fill() {
  buckets_.assign(lattice_.cellCount(), {});
  abandoned_ = 0;
  for (const std::uint32_t cell : cell_) ++buckets_[cell].room;
  std::uint32_t end = 0;
  for (Bucket& bucket : buckets_) {
    bucket.start = end;
    if (bucket.room > 0) bucket.room += spare;
    end += bucket.room;
  }
  points_.resize(end);
  for (Index i = 0; i < size(); ++i) {
    Bucket& bucket = buckets_[cell_[i]];
    points_[bucket.start + bucket.count++] = i;
  }
}

void MovableGrid::place(Index i, const Vec3& point) {
  const std::uint32_t cell = lattice_.cellOf(point);
  if (i == size()) {
    makeRoom(cell_, cell_.size() + 1);
    cell_.push_back(cell);
    add(i, cell);
  } else if (cell != cell_[i]) {
    take(i);
    cell_[i] = cell;
    add(i, cell);
  }
}

void MovableGrid::add(Index i, std::uint32_t cell) {
  Bucket& bucket = buckets_[cell];
  if (bucket.count == bucket.room) {
    abandoned_ += bucket.room;
    if (static_cast<double>(abandoned_) > mostAbandoned * static_cast<double>(points_.size())) {
      fill();  // of this point too
      return;
    }
    const Bucket before = bucket;
    bucket.start = static_cast<std::uint32_t>(points_.size());
    bucket.room += moreRoom;
    makeRoom(points_, points_.size() + bucket.room);
    points_.resize(points_.size() + bucket.room);
    std::copy_n(points_.begin() + before.start, before.count, points_.begin() + bucket.start);
  }
  points_[bucket.start + bucket.count++] = i;
}

void MovableGrid::take(Index i) {
  Bucket& bucket = buckets_[cell_[i]];
  const auto first = points_.begin() + bucket.start, last = first + bucket.count - 1;
  *std::find(first, last, i) = *last;
  --bucket.count;
}

}  // namespace restenosis
