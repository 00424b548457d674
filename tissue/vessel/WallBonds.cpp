#include "WallBonds.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "PointGrid.h"

namespace restenosis {

std::size_t bondWall(Wall& wall, double range) {
  const AgentStore& agents = wall.agents;
  wall.bonds = BondTable();
  wall.bonds.resize(agents.size());
  if (agents.size() == 0 || !(range > 0)) return 0;

  struct Pair {
    double distance;
    Index a, b;
  };
  const double largest = *std::ranges::max_element(agents.radius);
  const PointGrid grid(agents, 2 * range * largest);
  std::vector<Pair> pairs;
  for (Index a = 0; a < agents.size(); ++a) {
    if (agents.kind[a] == AgentKind::strut) continue;
    grid.visit(agents.position(a), range * (agents.radius[a] + largest), [&](Index b, double squared) {
      const double reach = range * (agents.radius[a] + agents.radius[b]);
      if (b > a && agents.kind[b] != AgentKind::strut && squared < reach * reach) {
        pairs.push_back({std::sqrt(squared), a, b});
      }
      return true;
    });
  }
  // Ids break ties, so that the order of agents in memory cannot matter.
  std::ranges::sort(pairs, [&](const Pair& p, const Pair& q) {
    const auto key = [&](const Pair& pair) {
      const auto [low, high] = std::minmax(agents.id[pair.a], agents.id[pair.b]);
      return std::tuple(pair.distance, low, high);
    };
    return key(p) < key(q);
  });
  std::size_t made = 0;
  for (const Pair& pair : pairs) made += wall.bonds.connect(pair.a, pair.b, pair.distance);
  return made;
}

}  // namespace restenosis
