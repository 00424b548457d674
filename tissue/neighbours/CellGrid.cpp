#include "CellGrid.h"

#include <fmt/format.h>

#include <stdexcept>

namespace restenosis {
namespace {

std::vector<Vec3> finitePositions(const AgentStore& agents) {
  std::vector<Vec3> points(agents.size());
  for (Index i = 0; i < agents.size(); ++i) points[i] = finitePosition(agents, i);
  return points;
}

}  // namespace

Vec3 finitePosition(const AgentStore& agents, Index i) {
  const Vec3 position = agents.position(i);
  if (position.allFinite()) return position;
  throw std::invalid_argument(fmt::format("agent {} has no finite position: ({}, {}, {}) m", agents.id[i],
                                          position.x(), position.y(), position.z()));
}

CellGrid::CellGrid(const AgentStore& agents, double cellSize) : CellGrid(finitePositions(agents), cellSize) {}

CellGrid::CellGrid(std::span<const Vec3> points, double cellSize) : lattice_(points, cellSize) {
  const auto count = static_cast<Index>(points.size());
  std::vector<std::uint32_t> cell(count);
  start_.assign(lattice_.cellCount() + 1, 0);
  for (Index i = 0; i < count; ++i) {
    cell[i] = lattice_.cellOf(points[i]);
    ++start_[cell[i] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(count);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (Index i = 0; i < count; ++i) order_[next[cell[i]]++] = i;
}

}  // namespace restenosis
