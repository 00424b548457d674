#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "AgentStore.h"

namespace restenosis {

/// Sorts agents into cubic cells of one size, each cell's agents in ascending order.
///
/// Cell coordinates are taken modulo the size of the grid, which never has more than a few cells an agent: an
/// agent far from all others shares a cell with some of them instead of stretching the grid, so whoever asks
/// must test distances, and does so anyway.
class CellGrid {
 public:
  /// `cellSize` > 0 [m]. Throws std::invalid_argument naming the agent when a position is not finite.
  CellGrid(const AgentStore& agents, double cellSize);

  double cellSize() const { return cellSize_; }
  std::size_t cellCount() const { return start_.size() - 1; }

  /// Calls f(j) once for each agent in a cell that the ball around `point` may touch, in no particular order.
  /// All agents within `distance` of `point` are among them.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    const Window wx = window(point.x(), distance, 0);
    const Window wy = window(point.y(), distance, 1);
    const Window wz = window(point.z(), distance, 2);
    for (std::int64_t kz = 0, z = wz.first; kz < wz.count; ++kz, z = next(z, 2)) {
      for (std::int64_t ky = 0, y = wy.first; ky < wy.count; ++ky, y = next(y, 1)) {
        const std::int64_t row = (z * size_[1] + y) * size_[0];
        for (std::int64_t kx = 0, x = wx.first; kx < wx.count; ++kx, x = next(x, 0)) {
          for (std::uint32_t n = start_[row + x]; n < start_[row + x + 1]; ++n) f(order_[n]);
        }
      }
    }
  }

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
