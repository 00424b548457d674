#pragma once

#include "tissue/agents/AgentStore.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// Numbers of agents in a wall (model 2): the total from the packing fraction, laminae from their coverage.
struct AgentCounts {
  Index iel = 0, eel = 0, smc = 0;
  Index total() const { return iel + eel + smc; }
};

/// Counts for a wall of this shape. Throws std::invalid_argument, with the parameters to change, when the
/// laminae alone exceed the packing fraction or the wall is thinner than four cell radii.
AgentCounts countAgents(const VesselParameters& vessel, const WallShape& shape);

}  // namespace restenosis
