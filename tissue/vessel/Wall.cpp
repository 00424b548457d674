#include "Wall.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace restenosis {
namespace {

/// The lowest 21 bits of `value`, each followed by two zero bits.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

}  // namespace

void fixEnds(Wall& wall, double radii) {
  const double depth = radii * wall.cellRadius;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    const double z = wall.agents.z[i];
    wall.agents.set(i, fixed, depth > 0 && (z < depth || z > wall.length - depth));
  }
}

void fixOuterLamina(Wall& wall) {
  for (Index i = 0; i < wall.agents.size(); ++i) {
    if (wall.agents.kind[i] == AgentKind::eel) wall.agents.set(i, fixed, true);
  }
}

void orderInSpace(Wall& wall) {
  AgentStore& agents = wall.agents;
  if (agents.size() == 0) return;
  const double cell = 4 * wall.cellRadius;
  const double xLow = *std::ranges::min_element(agents.x), yLow = *std::ranges::min_element(agents.y),
               zLow = *std::ranges::min_element(agents.z);
  const auto cellAt = [cell](double value, double low) {
    return spread(static_cast<std::uint64_t>((value - low) / cell));
  };
  std::vector<std::uint64_t> key(agents.size());
  for (Index i = 0; i < agents.size(); ++i) {
    key[i] = cellAt(agents.x[i], xLow) | cellAt(agents.y[i], yLow) << 1 | cellAt(agents.z[i], zLow) << 2;
  }
  std::vector<Index> order(agents.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, [&](Index a, Index b) {
    return std::pair(key[a], agents.id[a]) < std::pair(key[b], agents.id[b]);
  });
  agents.reorder(order);
  wall.bonds.resize(agents.size());
  wall.bonds.reorder(order);
}

}  // namespace restenosis
