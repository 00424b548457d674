#include <stdexcept>

#include "bridge/surface/SceneStent.h"
#include "tests/fuzz/FuzzTargets.h"
#include "tests/fuzz/MemoryFile.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {

void fuzzTable(std::string_view input) {
  static const MemoryFile memory, again;
  const auto file = memory.holding(input);
  const auto attempt = [](auto read) {
    try {
      read();
    } catch (const std::runtime_error&) {
      // Refused, as all of these readers say
    }
  };
  attempt([&] {
    const AgentTable table = readAgentTable(file);
    const auto copy = again.holding("");
    writeAgentTable(copy, table.agents);
    try {
      if (readAgentTable(copy).agents.size() != table.agents.size())
        throw std::logic_error("agents are lost");
    } catch (const TableError& error) {
      throw std::logic_error(error.what());  // a table that was written must be read
    }
  });
  VesselParameters vessel;
  vessel.agents = file;
  attempt([&] { readWallTable(vessel, {}); });
  StentParameters stent;
  attempt([&] { readWallTable(vessel, stent.deploymentDepth); });
  stent.file = file;
  attempt([&] { makeStent(stent, vessel); });
}

}  // namespace restenosis
