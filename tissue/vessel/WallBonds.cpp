#include "WallBonds.h"

#include <utility>
#include <vector>

#include "BondCandidates.h"
#include "NeighbourQuery.h"

namespace restenosis {

std::size_t bondWall(Wall& wall, double range) {
  const AgentStore& agents = wall.agents;
  wall.bonds = BondTable();
  wall.bonds.resize(agents.size());
  if (agents.size() == 0 || !(range > 0)) return 0;

  const CellGrid grid(agents, 2 * range * NeighbourQuery::largestRadius(agents));
  NeighbourQuery query(agents, grid);
  std::vector<BondCandidate> pairs;
  for (Index a = 0; a < agents.size(); ++a) {
    if (agents.kind[a] == AgentKind::strut) continue;
    query.forEachNeighbour(a, range, [&](Index b, double distance) {
      if (b > a && agents.kind[b] != AgentKind::strut) pairs.push_back({distance, a, b});
    });
  }
  return connectNearestFirst(agents, wall.bonds, std::move(pairs));
}

}  // namespace restenosis
