#pragma once

#include "tissue/vessel/AgentTable.h"

namespace restenosis {

/// Throws AgentTableError where two agents of a table, whose lines are known, are at one place: bonds of no
/// length have no strain, forces between agents at one place no direction, and a sphere that is there twice
/// pushes twice.
void requireDistinctPlaces(const AgentTable& table);

}  // namespace restenosis
