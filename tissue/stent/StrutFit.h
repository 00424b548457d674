#pragma once

#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Distance by which the spheres of a stent from a file are moved along their radii, so that the outermost
/// touches the lumen's surface [m]. They must fit the vessel's lumen (model 4, the stent): struts only, no
/// thicker than the lumen's radius, along the vessel's length, none over the axis, and all in the outer half
/// of the lumen's radius once the outermost touches the lumen. Throws TableError for the first sphere
/// that does not fit.
double outwardsToLumen(const AgentTable& struts, const VesselParameters& vessel);

}  // namespace restenosis
