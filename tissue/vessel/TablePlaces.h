#pragma once

#include "tissue/vessel/AgentTable.h"

namespace restenosis {

/// Throws TableError where two agents of a table with known lines are at one place: a bond of length 0
/// has no strain, a force between the two no direction, and a duplicate sphere pushes twice.
void requireDistinctPlaces(const AgentTable& table);

}  // namespace restenosis
