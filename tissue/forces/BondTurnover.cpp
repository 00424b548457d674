#include "tissue/forces/BondTurnover.h"

#include <utility>
#include <vector>

#include "tissue/agents/BondCandidates.h"
#include "tissue/agents/Chunks.h"
#include "tissue/neighbours/NeighbourQuery.h"

namespace restenosis {

std::size_t breakStrainedBonds(const AgentStore& agents, BondTable& bonds, double limit) {
  if (!(limit > 0)) return 0;
  const auto isIel = [&](Index i) { return agents.kind[i] == AgentKind::iel; };
  std::vector<std::pair<Index, Index>> strained;
  for (Index a = 0; a < agents.size(); ++a) {
    for (const Bond& bond : bonds.of(a)) {
      const Index b = bond.partner;
      if (b < a || (isIel(a) && isIel(b))) continue;
      if ((agents.position(a) - agents.position(b)).norm() > (1 + limit) * bond.restLength)
        strained.emplace_back(a, b);
    }
  }
  for (const auto& [a, b] : strained) bonds.disconnect(a, b);
  return strained.size();
}

std::size_t bondDaughters(const AgentStore& agents, BondTable& bonds, double range) {
  if (!(range > 0)) return 0;
  const std::vector<Index> unbonded =
      agentsThat(agents.size(), [&](Index i) { return agents.has(i, daughter) && bonds.of(i).empty(); });
  if (unbonded.empty()) return 0;
  const CellGrid grid(agents, 2 * range * NeighbourQuery::largestRadius(agents));
  NeighbourQuery query(agents, grid);
  std::vector<BondCandidate> candidates;
  for (const Index a : unbonded) {
    query.forEachNeighbour(a, range, [&](Index b, double distance) {
      if (agents.kind[b] != AgentKind::strut) candidates.push_back({distance, a, b});
    });
  }
  return connectNearestFirst(agents, bonds, std::move(candidates));
}

}  // namespace restenosis
