#pragma once

#include <filesystem>
#include <stdexcept>

#include "AgentStore.h"

namespace restenosis {

/// Thrown for a table that cannot be used; the message begins with the file and, where there is one, the
/// line.
struct AgentTableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads agents from a CSV table. The first line that is neither empty nor a comment (#) names the columns,
/// in any order: x, y, z, radius [um] and kind (smc, iel, eel, strut; without the column every agent is
/// `defaultKind`). Ids are given in the order of the lines. Throws AgentTableError for a missing or unknown
/// column, a wrong number of cells, a cell that is no finite number, a radius that is not positive, an
/// unknown kind, or a table without agents.
AgentStore readAgentTable(const std::filesystem::path& file, AgentKind defaultKind = AgentKind::smc);

/// Writes a table that readAgentTable reads back to within rounding. Throws AgentTableError if it cannot be
/// written.
void writeAgentTable(const std::filesystem::path& file, const AgentStore& agents);

}  // namespace restenosis
