#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tissue/agents/JaggedArray.h"
#include "tissue/neighbours/CellLattice.h"

namespace restenosis {

/// A cell list of points that move or are added, each at the same cost however many points there are.
/// CellGrid is quicker to make and to search.
class MovableGrid {
 public:
  /// Without points, for about `count` between the corners `low` and `high`; `cellSize` > 0 [m].
  MovableGrid(const Vec3& low, const Vec3& high, std::size_t count, double cellSize)
      : lattice_(low, high, count, cellSize) {
    buckets_.resize(lattice_.cellCount());
  }
  /// Of `count` points, pointAt(k) the k-th of them, all finite; `cellSize` > 0 [m].
  template <class PointAt>
  MovableGrid(std::size_t count, const PointAt& pointAt, double cellSize)
      : lattice_(count, pointAt, cellSize), cell_(count) {
    forEachInChunks(count, [&](std::size_t k) { cell_[k] = lattice_.cellOf(pointAt(k)); });
    fill();
  }

  Index size() const { return static_cast<Index>(cell_.size()); }
  void add(const Vec3& point);
  void move(Index i, const Vec3& point);

  /// Calls f(j) once for each point in a cell that the ball around `point` may touch, in no particular order.
  /// All points within `distance` of `point` are among them; others too, so distances must be tested.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, const F& f) const {
    lattice_.forEachRange(point, distance, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t cell = begin; cell < end; ++cell)
        for (const Index j : buckets_[static_cast<std::size_t>(cell)]) f(j);
    });
  }
  /// Whether wanted(j) holds for one of these points; ends where it does.
  template <class Wanted>
  bool anyCandidate(const Vec3& point, double distance, const Wanted& wanted) const {
    bool any = false;
    lattice_.forEachRange(point, distance, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t cell = begin; cell < end && !any; ++cell)
        any = std::ranges::any_of(buckets_[static_cast<std::size_t>(cell)], wanted);
    });
    return any;
  }

 private:
  /// Sorts every point into the bucket of its cell.
  void fill();
  void append(std::uint32_t cell, Index i);

  CellLattice lattice_;
  std::vector<std::uint32_t> cell_;  ///< of each point
  JaggedArray<Index> buckets_;       ///< the points of each cell
};

}  // namespace restenosis
