#pragma once

#include <string>

#include "tissue/stent/Stent.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The obstacle spheres of the file that a stent names, where the file has them: the rows of a CSV table, or
/// those that cover the struts of a surface file (`coverSolid`), told by its name's ending (SurfaceFile.h).
/// It must lie within the vessel, roughly: by this a mistaken unit is told. Whether spheres fit is for
/// outwardsToLumen to say. Throws std::runtime_error, which names the file and says what is wrong and what is
/// allowed; TableError for a table.
AgentTable readStruts(const StentParameters& stent, const VesselParameters& vessel);

/// What the surface file that a stent names holds, for people; empty where it names none. Throws as
/// readStruts does.
std::string describeStentFile(const StentParameters& stent);

/// The stent of a scene before deployment, its outer face at the lumen's surface: of a design or from a file.
/// Throws std::runtime_error for a file that cannot be used, std::invalid_argument for an unknown design.
Stent makeStent(const StentParameters& stent, const VesselParameters& vessel);

}  // namespace restenosis
