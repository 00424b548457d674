#pragma once

#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/RadiusMap.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// A lumen that lies along z as seen from its axis (x = y = 0): the distance of its side, sampled about
/// `spacing` [m] apart. Throws std::runtime_error where the axis does not see all of it.
RadiusMap lumenFromAxis(const TriSurface& lumen, double spacing);

/// The shape of the wall that is built outwards from such a lumen: its surfaces lie at their distances from
/// the lumen's wherever that is, so that the wall is equally thick around any section. Of `vessel` only
/// thickness and cell radius count. Throws as lumenFromAxis does, and where the lumen is too crooked for a
/// wall of that thickness.
WallShape wallOutwards(const TriSurface& lumen, const VesselParameters& vessel);

}  // namespace restenosis
