#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "CellLattice.h"
#include "Chunks.h"
#include "RowPool.h"

namespace restenosis {

/// Points in cubic cells of one size, for few points that move among many that stay: a move costs the same
/// however many points there are. CellGrid is quicker to make.
class MovableGrid {
 public:
  /// `count` points, pointAt(k) the k-th of them, all finite; `cellSize` > 0 [m].
  template <class PointAt>
  MovableGrid(std::size_t count, const PointAt& pointAt, double cellSize)
      : lattice_(count, pointAt, cellSize), cell_(count) {
    forEachInChunks(count, [&](std::size_t k) { cell_[k] = lattice_.cellOf(pointAt(k)); });
    fill();
  }

  Index size() const { return static_cast<Index>(cell_.size()); }
  /// Puts point i elsewhere; i = size() adds one.
  void place(Index i, const Vec3& point);

  /// Calls f(j) once for each point in a cell that the ball around `point` may touch, in no particular order.
  /// All points within `distance` of `point` are among them; others too, so distances must be tested.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    lattice_.forEachRow(point, distance, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t cell = begin; cell < end; ++cell) {
        for (const Index j : buckets_[static_cast<std::size_t>(cell)]) f(j);
      }
    });
  }

 private:
  /// Puts every point into the bucket of its cell.
  void fill();
  void add(Index i, std::uint32_t cell);
  void take(Index i);

  CellLattice lattice_;
  std::vector<std::uint32_t> cell_;  ///< of each point
  RowPool<Index> buckets_;           ///< the points of each cell
};

}  // namespace restenosis
