#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A uniform grid of points that can grow: answers which points lie within a reach of a place. Points outside
/// the box given at construction are kept in the nearest cell, so that a query near them still finds them.
class PointGrid {
 public:
  /// `low` and `high` bound the points [m]; `cell` is the edge of a cell [m], best about the usual reach.
  PointGrid(const Vec3& low, const Vec3& high, double cell);

  void insert(Index name, const Vec3& point);

  /// Calls f(name, squared distance) for every point nearer than `reach`, in an order that depends only on
  /// the order of insertion: first those in the cell of the place, who are the likeliest to be near.
  /// `f` returns true to go on, false to stop; the result tells whether it went to the end.
  template <class F>
  bool visit(const Vec3& place, double reach, F&& f) const {
    const auto own = cellOf(place);
    const auto low = cellOf(place - Vec3::Constant(reach)), high = cellOf(place + Vec3::Constant(reach));
    const auto visitCell = [&](const std::array<int, 3>& cell) {
      for (const Entry* entry = &cells_[flat(cell)]; entry->name != none; entry = &more_[entry->next]) {
        const double squared = (entry->point - place).squaredNorm();
        if (squared < reach * reach && !f(entry->name, squared)) return false;
        if (entry->next == none) break;
      }
      return true;
    };
    if (!visitCell(own)) return false;
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          const std::array<int, 3> cell{i, j, k};
          if (cell != own && !visitCell(cell)) return false;
        }
      }
    }
    return true;
  }
  /// Asks for the memory that a visit of this place needs most likely. Speed only.
  void fetch(const Vec3& place) const;

 private:
  static constexpr Index none = static_cast<Index>(-1);
  struct alignas(32) Entry {
    Vec3 point;
    Index name = none;
    Index next = none;  ///< of the same cell, in more_
  };

  std::array<int, 3> cellOf(const Vec3& point) const {
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<int>(
          std::clamp(std::floor((point[axis] - low_[axis]) / cell_), 0.0, count_[axis] - 1.0));
    }
    return cell;
  }
  std::size_t flat(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * count_[1] + cell[1]) * count_[0] + cell[0];
  }

  Vec3 low_;
  double cell_;
  std::array<int, 3> count_;
  std::vector<Entry> cells_;  ///< the first point of each
  std::vector<Entry> more_;
};

}  // namespace restenosis
