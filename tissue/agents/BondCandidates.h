#pragma once

#include <cstddef>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"

namespace restenosis {

/// Two agents that may be bonded.
struct BondCandidate {
  double distance;  ///< of their centres [m]
  Index a, b;
};

/// Centres nearer than this times R1 + R2 are those of agents that are about to push each other away, not of
/// neighbours at rest: a bond of that length would hold one within the other. Assumed; no wall that has been
/// packed or deployed has such a pair.
inline constexpr double nearestBonded = 0.5;

/// Bonds candidates, the nearest first, as long as neither has BondTable::maxBonds, they are not bonded
/// yet and are no nearer than nearestBonded. The rest length is their distance, so that the bonds carry
/// nothing now. Ids break ties, so that the order of agents in memory cannot matter. A pair may be named more
/// than once. Returns the number of bonds made.
std::size_t connectNearestFirst(const AgentStore& agents, BondTable& bonds,
                                std::vector<BondCandidate> candidates);

}  // namespace restenosis
