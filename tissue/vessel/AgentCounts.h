#pragma once

#include "AgentStore.h"
#include "VesselParameters.h"

namespace restenosis {

/// How many agents a wall has (model 2): all of them from the packing fraction, laminae from their coverage.
struct AgentCounts {
  Index iel = 0, eel = 0, smc = 0;
  Index total() const { return iel + eel + smc; }
};

/// Counts for a vessel; throws std::invalid_argument when the laminae alone are more than the packing
/// fraction allows, naming the parameters to change.
AgentCounts countAgents(const VesselParameters& vessel);

/// Distance of the centres of the IEL's agents from the axis: one cell radius outside the lumen [m].
inline double ielRadius(const VesselParameters& vessel) {
  return vessel.lumenDiameter / 2 + vessel.cellRadius;
}
/// Distance of the centres of the EEL's agents from the axis: one cell radius inside the wall's outer face
/// [m].
inline double eelRadius(const VesselParameters& vessel) {
  return vessel.lumenDiameter / 2 + vessel.wallThickness - vessel.cellRadius;
}

}  // namespace restenosis
