#include "PointGrid.h"

#include <stdexcept>

namespace restenosis {
namespace {

Vec3 lowest(const AgentStore& agents) {
  Vec3 low = agents.size() ? agents.position(0) : Vec3::Zero();
  for (Index i = 0; i < agents.size(); ++i) low = low.cwiseMin(agents.position(i));
  return low;
}

Vec3 highest(const AgentStore& agents) {
  Vec3 high = agents.size() ? agents.position(0) : Vec3::Zero();
  for (Index i = 0; i < agents.size(); ++i) high = high.cwiseMax(agents.position(i));
  return high;
}

}  // namespace

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
  first_.assign(cells, none);
}

PointGrid::PointGrid(const AgentStore& agents, double cell)
    : PointGrid(lowest(agents), highest(agents), cell) {
  entries_.reserve(agents.size());
  for (Index i = 0; i < agents.size(); ++i) insert(i, agents.position(i));
}

void PointGrid::insert(Index name, const Vec3& point) {
  Index& first = first_[flat(cellOf(point))];
  entries_.push_back({point, name, first});
  first = static_cast<Index>(entries_.size() - 1);
}

}  // namespace restenosis
