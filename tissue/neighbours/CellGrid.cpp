#include "CellGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace restenosis {
namespace {

// Enough cells for a thin wall in its bounding box; more would cost memory without making cells emptier.
constexpr double cellsPerAgent = 8;
constexpr double fewestCells = 4096;
constexpr std::int64_t smallestSide = 4;

double cellOf(double coordinate, double cellSize) { return std::floor(coordinate / cellSize); }

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

CellGrid::CellGrid(std::span<const Vec3> points, double cellSize) : cellSize_(cellSize) {
  if (!(cellSize > 0) || !std::isfinite(cellSize)) {
    throw std::invalid_argument(
        fmt::format("the cells of a neighbour grid need a size above 0, got {} m", cellSize));
  }
  const auto count = static_cast<Index>(points.size());
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  if (count > 0) low = high = points[0];
  for (const Vec3& point : points) low = low.cwiseMin(point), high = high.cwiseMax(point);
  std::array<double, 3> sides{};
  for (int axis = 0; axis < 3; ++axis) {
    // One empty layer, so that the two ends of the grid are not neighbours.
    sides[axis] = count == 0 ? 0 : cellOf(high[axis], cellSize) - cellOf(low[axis], cellSize) + 2;
    sides[axis] = std::max(sides[axis], static_cast<double>(smallestSide));
  }
  const double mostCells = fewestCells + cellsPerAgent * count;
  while (sides[0] * sides[1] * sides[2] > mostCells) {
    auto& longest = *std::max_element(sides.begin(), sides.end());
    longest = std::max(std::ceil(longest / 2), static_cast<double>(smallestSide));
  }
  for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<std::int64_t>(sides[axis]);

  std::vector<std::uint32_t> cell(count);
  start_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]) + 1, 0);
  for (Index i = 0; i < count; ++i) {
    const auto x = wrapped(cellOf(points[i].x(), cellSize), 0);
    const auto y = wrapped(cellOf(points[i].y(), cellSize), 1);
    const auto z = wrapped(cellOf(points[i].z(), cellSize), 2);
    cell[i] = static_cast<std::uint32_t>((z * size_[1] + y) * size_[0] + x);
    ++start_[cell[i] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(count);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (Index i = 0; i < count; ++i) order_[next[cell[i]]++] = i;
}

std::int64_t CellGrid::wrapped(double cellCoordinate, int axis) const {
  const auto side = static_cast<double>(size_[axis]);
  const double remainder = cellCoordinate - side * std::floor(cellCoordinate / side);
  // Coordinates beyond 2^53 cells lose their last digits; they still belong to some cell.
  return static_cast<std::int64_t>(std::clamp(remainder, 0.0, side - 1));
}

CellGrid::Window CellGrid::window(double coordinate, double distance, int axis) const {
  const double first = cellOf(coordinate - distance, cellSize_);
  const double count = cellOf(coordinate + distance, cellSize_) - first + 1;
  if (!(count < static_cast<double>(size_[axis]))) return {0, size_[axis]};
  return {wrapped(first, axis), static_cast<std::int64_t>(count)};
}

}  // namespace restenosis
