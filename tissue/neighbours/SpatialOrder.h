#pragma once

#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A permutation that puts agents near each other in space near each other in memory: order[k] is the agent
/// to stand at position k, for AgentStore::reorder and BondTable::reorder. Follows a Z-order curve through
/// cells about two agents wide; agents of one cell are ordered by id, so the order depends on positions and
/// ids only.
std::vector<Index> spatialOrder(const AgentStore& agents);

}  // namespace restenosis
