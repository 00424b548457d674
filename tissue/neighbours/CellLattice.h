#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/Chunks.h"

namespace restenosis {

/// Cubic cells of one size that fill space, numbered modulo the sides of a box that has never more than a few
/// cells a point: a point far from all others shares a cell with some of them instead of stretching the box.
/// A search for points in a cell must therefore test distances, as it does anyway.
class CellLattice {
 public:
  /// For `count` points, pointAt(k) the k-th of them, all finite. `cellSize` > 0 [m], or
  /// std::invalid_argument is thrown.
  template <class PointAt>
  CellLattice(std::size_t count, const PointAt& pointAt, double cellSize)
      : CellLattice(boxOf(count, pointAt), count, cellSize) {}
  /// For about `count` points between the corners `low` and `high` [m].
  CellLattice(const Vec3& low, const Vec3& high, std::size_t count, double cellSize)
      : CellLattice(Box{low, high}, count, cellSize) {}

  double cellSize() const { return cellSize_; }
  std::size_t cellCount() const { return static_cast<std::size_t>(size_[0] * size_[1] * size_[2]); }
  std::uint32_t cellOf(const Vec3& point) const;

  /// Calls f(begin, end) for ranges of cells [begin, end) that the ball around `point` may touch, no cell
  /// twice: all points within `distance` of `point` are in one of them.
  template <class F>
  void forEachRange(const Vec3& point, double distance, const F& f) const {
    const Window wx = window(point.x(), distance, 0);
    const Window wy = window(point.y(), distance, 1);
    const Window wz = window(point.z(), distance, 2);
    const std::int64_t whole = std::min(wx.count, size_[0] - wx.first);  // cells before x wraps around
    for (std::int64_t kz = 0, z = wz.first; kz < wz.count; ++kz, z = next(z, 2)) {
      for (std::int64_t ky = 0, y = wy.first; ky < wy.count; ++ky, y = next(y, 1)) {
        const std::int64_t line = (z * size_[1] + y) * size_[0];
        f(line + wx.first, line + wx.first + whole);
        if (whole < wx.count) f(line, line + wx.count - whole);
      }
    }
  }

 private:
  struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    void join(const Box& other) { low = low.cwiseMin(other.low), high = high.cwiseMax(other.high); }
  };
  template <class PointAt>
  static Box boxOf(std::size_t count, const PointAt& pointAt) {
    return reduceInChunks<Box>(count, [&](std::size_t k, Box& part) {
      const Vec3 point = pointAt(k);
      part.join({point, point});
    });
  }
  CellLattice(const Box& box, std::size_t count, double cellSize);
  /// `count` cells from `first` on, wrapping around: no cell twice.
  struct Window {
    std::int64_t first, count;
  };
  Window window(double coordinate, double distance, int axis) const;
  std::int64_t next(std::int64_t cell, int axis) const { return cell + 1 == size_[axis] ? 0 : cell + 1; }
  std::int64_t wrapped(double cellCoordinate, int axis) const;

  double cellSize_;
  std::array<std::int64_t, 3> size_{};
};

}  // namespace restenosis
