#include "tissue/neighbours/CellLattice.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace restenosis {
namespace {

// Enough cells for a thin wall in its bounding box; more would cost memory without making cells emptier.
constexpr double cellsPerPoint = 8;
constexpr double fewestCells = 4096;
constexpr std::int64_t smallestSide = 4;

double cellAlong(double coordinate, double cellSize) { return std::floor(coordinate / cellSize); }

}  // namespace

CellLattice::CellLattice(const Box& box, std::size_t count, double cellSize) : cellSize_(cellSize) {
  if (!(cellSize > 0) || !std::isfinite(cellSize)) {
    throw std::invalid_argument(
        fmt::format("the cells of a neighbour grid need a size above 0, got {} m", cellSize));
  }
  std::array<double, 3> sides{};
  for (int axis = 0; axis < 3; ++axis) {
    // One empty layer, so that the two ends of the grid are not neighbours.
    sides[axis] =
        count == 0 ? 0 : cellAlong(box.high[axis], cellSize) - cellAlong(box.low[axis], cellSize) + 2;
    sides[axis] = std::max(sides[axis], static_cast<double>(smallestSide));
  }
  const double mostCells = fewestCells + cellsPerPoint * static_cast<double>(count);
  while (sides[0] * sides[1] * sides[2] > mostCells) {
    auto& longest = *std::max_element(sides.begin(), sides.end());
    longest = std::max(std::ceil(longest / 2), static_cast<double>(smallestSide));
  }
  for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<std::int64_t>(sides[axis]);
}

std::uint32_t CellLattice::cellOf(const Vec3& point) const {
  const auto x = wrapped(cellAlong(point.x(), cellSize_), 0);
  const auto y = wrapped(cellAlong(point.y(), cellSize_), 1);
  const auto z = wrapped(cellAlong(point.z(), cellSize_), 2);
  return static_cast<std::uint32_t>((z * size_[1] + y) * size_[0] + x);
}

std::int64_t CellLattice::wrapped(double cellCoordinate, int axis) const {
  const auto side = static_cast<double>(size_[axis]);
  const double remainder = cellCoordinate - side * std::floor(cellCoordinate / side);
  // Coordinates beyond 2^53 cells lose their last digits; they still belong to some cell.
  return static_cast<std::int64_t>(std::clamp(remainder, 0.0, side - 1));
}

CellLattice::Window CellLattice::window(double coordinate, double distance, int axis) const {
  const double first = cellAlong(coordinate - distance, cellSize_);
  const double count = cellAlong(coordinate + distance, cellSize_) - first + 1;
  if (!(count < static_cast<double>(size_[axis]))) return {0, size_[axis]};
  return {.first = wrapped(first, axis), .count = static_cast<std::int64_t>(count)};
}

}  // namespace restenosis
