#pragma once

#include <optional>
#include <string>

#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Reads the wall that `vessel.agents` names, for a scene whose stent is pressed in by `deploymentDepth` [m]
/// (nothing: no stent). It may be deformed, and may be a few cells only, but it must fit the vessel (model 2,
/// loaded walls): radii like `vessel.cellRadius`, centres along its length and about its axis, no two at the
/// same place. A wall with laminae or a stent surrounds the axis, without long gaps, and nothing but the EEL
/// lies outside of it. Beside a stent it holds no struts and encloses the place that the stent is pressed to.
/// Throws AgentTableError, with the line of the first agent that does not fit.
AgentStore readWallTable(const VesselParameters& vessel, std::optional<double> deploymentDepth);

/// What is to be said of a wall with laminae that reaches less far than `vessel.length`: nobody stands where
/// the ends are held, so that the wall can grow out of its cut face. Empty where there is nothing to say.
std::string remarkOnOpenEnds(const VesselParameters& vessel, const AgentStore& agents);

}  // namespace restenosis
