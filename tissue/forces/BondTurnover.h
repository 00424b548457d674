#pragma once

#include <cstddef>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"

namespace restenosis {

/// Breaks every bond with a strain (distance over rest length, less 1) past `limit`, but those within the
/// IEL, the breaking of which is an injury (InjuryParameters). A limit of 0 breaks none. Returns how many
/// broke.
std::size_t breakStrainedBonds(const AgentStore& agents, BondTable& bonds, double limit);

/// Bonds the daughters that have no bonds, as the packed wall is bonded: to agents (not struts) with centres
/// nearer than `range` times the sum of the radii, the nearest first, at their present distances. A
/// daughter without agents in range stays without. Returns the number of bonds made.
std::size_t bondDaughters(const AgentStore& agents, BondTable& bonds, double range);

}  // namespace restenosis
