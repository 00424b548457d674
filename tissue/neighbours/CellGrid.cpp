#include "CellGrid.h"

#include <fmt/format.h>

#include <stdexcept>

#include "Chunks.h"

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
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  std::vector<std::uint32_t> cell(points.size());
#pragma omp parallel for schedule(static) if (count >= parallelLookFrom)
  for (std::ptrdiff_t i = 0; i < count; ++i) cell[i] = lattice_.cellOf(points[i]);

  // While agents are put in, the entry after a cell's is where its next one goes: at last, the next cell's
  // first.
  start_.assign(lattice_.cellCount() + 2, 0);
  for (const std::uint32_t c : cell) ++start_[c + 2];
  for (std::size_t c = 2; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(points.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) order_[start_[cell[i] + 1]++] = static_cast<Index>(i);
  start_.pop_back();
}

}  // namespace restenosis
