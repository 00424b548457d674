#pragma once

#include <optional>
#include <string>

#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Reads the wall of the file `vessel.agents`, for a scene with a stent that is pressed in by
/// `deploymentDepth` [m] (nothing: no stent). It may be deformed, and may be a few cells only, but it must
/// fit the vessel (model 2, loaded walls): radii like `vessel.cellRadius`, centres along its length and about
/// its axis, no two at the same place. A wall with laminae or a stent surrounds the axis, without long gaps,
/// and nothing but the EEL lies outside of it. Beside a stent it holds no struts and encloses the place that
/// the stent is pressed to. Throws TableError, with the line of the first agent that does not fit.
AgentStore readWallTable(const VesselParameters& vessel, std::optional<double> deploymentDepth);

/// Remark on a wall with laminae that is shorter than `vessel.length`: no agent is where the ends are held,
/// so the wall can grow out of its cut face. Empty for any other wall.
std::string remarkOnOpenEnds(const VesselParameters& vessel, const AgentStore& agents);

}  // namespace restenosis
