#include "tissue/neighbours/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tissue/neighbours/NeighbourQuery.h"

namespace restenosis {
namespace {

constexpr int bitsPerAxis = 21;

/// Spreads the low 21 bits of `v` to every third bit.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x001f00000000ffff;
  v = (v | v << 16) & 0x001f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  return (v | v << 2) & 0x1249249249249249;
}

std::uint64_t cellAlong(double coordinate, double low, double cellSize) {
  const double cell = std::floor((coordinate - low) / cellSize);
  return static_cast<std::uint64_t>(std::clamp(cell, 0.0, std::exp2(bitsPerAxis) - 1));
}

}  // namespace

std::vector<Index> spatialOrder(const AgentStore& agents) {
  std::vector<Index> order(agents.size());
  std::iota(order.begin(), order.end(), Index{0});
  if (agents.size() == 0) return order;

  const double radius = NeighbourQuery::largestRadius(agents);
  const double cellSize = radius > 0 ? 4 * radius : 1.0;
  const double lowX = *std::ranges::min_element(agents.x);
  const double lowY = *std::ranges::min_element(agents.y);
  const double lowZ = *std::ranges::min_element(agents.z);
  std::vector<std::uint64_t> key(agents.size());
  for (Index i = 0; i < agents.size(); ++i) {
    key[i] = spread(cellAlong(agents.x[i], lowX, cellSize)) |
             spread(cellAlong(agents.y[i], lowY, cellSize)) << 1 |
             spread(cellAlong(agents.z[i], lowZ, cellSize)) << 2;
  }
  std::ranges::sort(order, [&](Index a, Index b) {
    return key[a] != key[b] ? key[a] < key[b] : agents.id[a] < agents.id[b];
  });
  return order;
}

}  // namespace restenosis
