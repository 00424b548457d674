#include "tissue/neighbours/CellGrid.h"

#include <fmt/format.h>

#include <stdexcept>

namespace restenosis {
namespace {

const AgentStore& requireFinite(const AgentStore& agents) {
  for (Index i = 0; i < agents.size(); ++i) finitePosition(agents, i);
  return agents;
}

}  // namespace

Vec3 finitePosition(const AgentStore& agents, Index i) {
  const Vec3 position = agents.position(i);
  if (position.allFinite()) return position;
  throw std::invalid_argument(fmt::format("agent {} has no finite position: ({}, {}, {}) m", agents.id[i],
                                          position.x(), position.y(), position.z()));
}

CellGrid::CellGrid(const AgentStore& agents, double cellSize)
    : CellGrid(
          requireFinite(agents).size(), [&](std::size_t i) { return agents.position(static_cast<Index>(i)); },
          cellSize) {}

void CellGrid::sort(std::span<const std::uint32_t> cell) {
  // While agents are put in, the entry after a cell's is where its next one goes: at last, the next cell's
  // first.
  start_.assign(lattice_.cellCount() + 2, 0);
  for (const std::uint32_t c : cell) ++start_[c + 2];
  for (std::size_t c = 2; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(cell.size());
  for (std::size_t i = 0; i < cell.size(); ++i) order_[start_[cell[i] + 1]++] = static_cast<Index>(i);
  start_.pop_back();
}

}  // namespace restenosis
