#include "tissue/vessel/WallBonds.h"

#include <vector>

#include "tissue/agents/BondCandidates.h"
#include "tissue/agents/Chunks.h"
#include "tissue/neighbours/NeighbourQuery.h"

namespace restenosis {

std::size_t bondWall(Wall& wall, double range) {
  const AgentStore& agents = wall.agents;
  wall.bonds = BondTable();
  wall.bonds.resize(agents.size());
  if (agents.size() == 0 || !(range > 0)) return 0;

  const double largest = NeighbourQuery::largestRadius(agents);
  const CellGrid grid(agents, 2 * range * largest);
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<BondCandidate>& pairs) {
    NeighbourQuery query(agents, grid, largest);
    for (Index a = static_cast<Index>(begin); a < end; ++a) {
      if (agents.kind[a] == AgentKind::strut) continue;
      query.forEachNeighbour(a, range, [&](Index b, double distance) {
        if (b > a && agents.kind[b] != AgentKind::strut) pairs.push_back({distance, a, b});
      });
    }
  };
  return connectNearestFirst(agents, wall.bonds, gatherChunks<BondCandidate>(agents.size(), find));
}

}  // namespace restenosis
