#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/parameters/CsvLines.h"

namespace restenosis {

/// The agents of a file, with the line of each.
struct AgentTable {
  std::filesystem::path file;
  AgentStore agents;
  /// Line of each agent, from 1. Empty where agents do not come from lines of a file.
  std::vector<std::size_t> lines;

  /// For messages: "line 5", or, without lines, the agent's place in mm.
  std::string placeOf(Index i) const;
  /// Throws a TableError about agent i: file, line or place, message.
  [[noreturn]] void fail(Index i, const std::string& message) const;
};

/// Reads agents from a CSV table. The first line that is neither empty nor a comment names the columns, in
/// any order: x, y, z, radius [um], kind (smc, iel, eel, strut; without the column every agent is
/// `defaultKind`) and birthRadius [um] (without the column, the radius: every cell is as large as it was
/// born). A comment goes from # to the end of its line. Ids are given in the order of the lines. Throws
/// TableError for a missing or unknown column, a wrong number of cells, a cell that is no finite number,
/// a radius that is not positive, a radius at birth from which no cell grows to its present one, an unknown
/// kind, or a table without agents. readWallTable and outwardsToLumen check whether the agents fit a vessel.
AgentTable readAgentTable(const std::filesystem::path& file, AgentKind defaultKind = AgentKind::smc);

/// Writes a table that readAgentTable reads back to within rounding. Throws TableError if it cannot be
/// written.
void writeAgentTable(const std::filesystem::path& file, const AgentStore& agents);

}  // namespace restenosis
