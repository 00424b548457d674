#pragma once

#include "tissue/vessel/AgentTable.h"

namespace restenosis {

/// Checks that no cell is outside the EEL: throws TableError, with the line of the first agent of kind
/// smc or iel with its centre further outside than its radius and than `cellRadius` [m]. The EEL is the
/// radius map of its agents, as in OuterConfinement; places without EEL agents nearby are not checked.
void requireInsideEel(const AgentTable& table, double cellRadius);

}  // namespace restenosis
