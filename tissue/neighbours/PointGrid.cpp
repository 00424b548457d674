#include "tissue/neighbours/PointGrid.h"

#include <stdexcept>
#include <utility>

namespace restenosis {
PointGrid::PointGrid(const Vec3& low, const Vec3& high, double cell) : low_(low), cell_(cell) {
  // Beyond this many cells along an axis memory would go to empty cells; clamped cells stay correct.
  constexpr double mostCells = 1024;
  if (!(cell > 0)) throw std::invalid_argument("PointGrid: the cell size must be positive");
  cell_ = std::max(cell, (high - low).maxCoeff() / mostCells);
  std::size_t cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    count_[axis] = 1 + static_cast<int>(std::max(0.0, high[axis] - low[axis]) / cell_);
    cells *= static_cast<std::size_t>(count_[axis]);
  }
  cells_.resize(cells);
}

void PointGrid::insert(Index name, const Vec3& point) {
  Entry& first = cells_[flat(cellOf(point))];
  const Entry entry{.point = point, .name = name};
  if (first.name == none) {
    first = entry;
    return;
  }
  more_.push_back(entry);
  more_.back().next = std::exchange(first.next, static_cast<Index>(more_.size() - 1));
}

void PointGrid::fetch(const Vec3& place) const {
  const auto [i, j, k] = cellOf(place);
  const int west = std::max(i - 1, 0), east = std::min(i + 1, count_[0] - 1);
  for (int z = std::max(k - 1, 0); z <= std::min(k + 1, count_[2] - 1); ++z) {
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, count_[1] - 1); ++y) {
      __builtin_prefetch(&cells_[flat({west, y, z})]);
      __builtin_prefetch(&cells_[flat({east, y, z})]);
    }
  }
}

}  // namespace restenosis
