#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "AgentStore.h"

namespace restenosis {

/// Position of agent i [m]. Throws std::invalid_argument naming the agent when it is not finite.
Vec3 finitePosition(const AgentStore& agents, Index i);

/// Sorts agents into cubic cells of one size, each cell's agents in ascending order.
///
/// Cell coordinates are taken modulo the size of the grid, which never has more than a few cells an agent: an
/// agent far from all others shares a cell with some of them instead of stretching the grid, so whoever asks
/// must test distances, and does so anyway.
class CellGrid {
 public:
  /// `cellSize` > 0 [m]. Throws std::invalid_argument naming the agent when a position is not finite.
  CellGrid(const AgentStore& agents, double cellSize);
  /// Sorts points instead, all finite; "agent" stands for a place in `points` then.
  CellGrid(std::span<const Vec3> points, double cellSize);

  double cellSize() const { return cellSize_; }
  std::size_t cellCount() const { return start_.size() - 1; }

  /// Calls f(j) once for each agent in a cell that the ball around `point` may touch, in no particular order.
  /// All agents within `distance` of `point` are among them.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    forEachCandidateRange(point, distance, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t n = begin; n < end; ++n) f(order_[n]);
    });
  }

  /// The same agents as ranges [begin, end) of places in order(), for those who keep data in that order.
  template <class F>
  void forEachCandidateRange(const Vec3& point, double distance, F&& f) const {
    const Window wx = window(point.x(), distance, 0);
    const Window wy = window(point.y(), distance, 1);
    const Window wz = window(point.z(), distance, 2);
    const std::int64_t whole = std::min(wx.count, size_[0] - wx.first);  // cells before the row wraps around
    for (std::int64_t kz = 0, z = wz.first; kz < wz.count; ++kz, z = next(z, 2)) {
      for (std::int64_t ky = 0, y = wy.first; ky < wy.count; ++ky, y = next(y, 1)) {
        const std::int64_t row = (z * size_[1] + y) * size_[0];
        f(start_[row + wx.first], start_[row + wx.first + whole]);
        if (whole < wx.count) f(start_[row], start_[row + wx.count - whole]);
      }
    }
  }

  /// All agents, cell by cell.
  std::span<const Index> order() const { return order_; }

 private:
  /// `count` cells from `first` on, wrapping around: no cell twice.
  struct Window {
    std::int64_t first, count;
  };
  Window window(double coordinate, double distance, int axis) const;
  std::int64_t next(std::int64_t cell, int axis) const { return cell + 1 == size_[axis] ? 0 : cell + 1; }
  std::int64_t wrapped(double cellCoordinate, int axis) const;

  double cellSize_;
  std::array<std::int64_t, 3> size_{};
  std::vector<std::uint32_t> start_;  ///< first entry of each cell in order_, and the end
  std::vector<Index> order_;
};

}  // namespace restenosis
