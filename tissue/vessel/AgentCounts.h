#pragma once

#include "tissue/agents/AgentStore.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// How many agents a wall has (model 2): all of them from the packing fraction, laminae from their coverage.
struct AgentCounts {
  Index iel = 0, eel = 0, smc = 0;
  Index total() const { return iel + eel + smc; }
};

/// Counts for a wall of this shape; throws std::invalid_argument when the laminae alone are more than the
/// packing fraction allows, naming the parameters to change.
AgentCounts countAgents(const VesselParameters& vessel, const WallShape& shape);

}  // namespace restenosis
