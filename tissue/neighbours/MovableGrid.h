#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "CellLattice.h"
#include "Chunks.h"

namespace restenosis {

/// Points in cubic cells of one size, for few points that move among many that stay: a move costs the same
/// however many points there are. CellGrid is quicker to make and to read.
class MovableGrid {
 public:
  /// `count` points, pointAt(k) the k-th of them, all finite; `cellSize` > 0 [m].
  template <class PointAt>
  MovableGrid(std::size_t count, const PointAt& pointAt, double cellSize)
      : lattice_(count, pointAt, cellSize),
        first_(lattice_.cellCount(), none),
        next_(count, none),
        cell_(count) {
    forEachInChunks(count, [&](std::size_t k) { cell_[k] = lattice_.cellOf(pointAt(k)); });
    for (Index i = 0; i < size(); ++i) link(i, cell_[i]);
  }

  Index size() const { return static_cast<Index>(next_.size()); }
  /// Puts point i elsewhere; i = size() adds one.
  void place(Index i, const Vec3& point);

  /// Calls f(j) once for each point in a cell that the ball around `point` may touch, in no particular order.
  /// All points within `distance` of `point` are among them; others too, so distances must be tested.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    lattice_.forEachRow(point, distance, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t cell = begin; cell < end; ++cell) {
        for (Index j = first_[cell]; j != none; j = next_[j]) f(j);
      }
    });
  }

 private:
  static constexpr Index none = std::numeric_limits<Index>::max();
  void link(Index i, std::uint32_t cell);
  void unlink(Index i);

  CellLattice lattice_;
  std::vector<Index> first_;         ///< of each cell's points
  std::vector<Index> next_;          ///< of the same cell
  std::vector<std::uint32_t> cell_;  ///< of each point
};

}  // namespace restenosis
