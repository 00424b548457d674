#pragma once

#include "tissue/vessel/AgentTable.h"

namespace restenosis {

/// Nothing leaves a wall through its EEL: throws AgentTableError, with the line of the first agent of kind
/// smc or iel whose centre lies further outside the EEL than its radius, or than `cellRadius` [m] where that
/// is more. The EEL is the smooth radius map of its agents, which confines cells in a run, and is looked at
/// only where some of these are near.
void requireInsideEel(const AgentTable& table, double cellRadius);

}  // namespace restenosis
