#pragma once

#include "AgentTable.h"
#include "StentParameters.h"
#include "VesselParameters.h"

namespace restenosis {

/// The obstacle spheres of a table, and how they are put to the lumen's surface.
struct StrutTable {
  AgentStore spheres;   ///< where the table has them
  double outwards = 0;  ///< by this much along its radius each is moved, so that the outermost touches [m]
};

/// Reads the spheres that `stent.file` names. They must fit the vessel's lumen (model 4, the stent): struts
/// only, no thicker than the lumen's radius, along the vessel's length, none over the axis, and all in the
/// outer half of the lumen's radius once the outermost touches the lumen. Throws AgentTableError, with the
/// line of the first sphere that does not fit.
StrutTable readStrutTable(const StentParameters& stent, const VesselParameters& vessel);

}  // namespace restenosis
