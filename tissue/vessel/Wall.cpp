#include "tissue/vessel/Wall.h"

#include "tissue/neighbours/SpatialOrder.h"

namespace restenosis {

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

std::vector<Index> orderInSpace(Wall& wall) {
  std::vector<Index> order = spatialOrder(wall.agents);
  wall.agents.reorder(order);
  wall.bonds.resize(wall.agents.size());
  wall.bonds.reorder(order);
  return order;
}

}  // namespace restenosis
