#pragma once

#include <cstddef>
#include <vector>

#include "AgentStore.h"
#include "BondTable.h"

namespace restenosis {

/// Two agents that may be bonded.
struct BondCandidate {
  double distance;  ///< of their centres [m]
  Index a, b;
};

/// Bonds candidates, the nearest first, as long as both have room (BondTable::maxBonds) and are not bonded
/// yet. The rest length is their distance, so that the bonds carry nothing now. Ids break ties, so that the
/// order of agents in memory cannot matter. A pair may be named more than once. Returns the number of bonds
/// made.
std::size_t connectNearestFirst(const AgentStore& agents, BondTable& bonds,
                                std::vector<BondCandidate> candidates);

}  // namespace restenosis
