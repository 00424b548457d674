#pragma once

#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// The lumen of `vessel.lumenSurface` in the coordinates of the tissue that is built around it: the inlet in
/// the plane z = 0 with its centre in the origin, the outlet parallel to it. Throws std::runtime_error where
/// it cannot be read or has no two parallel ends.
TriSurface lumenOfTissue(const VesselParameters& vessel);

/// The shape of the wall around it. Throws as lumenOfTissue and wallOutwards do.
WallShape loadedWallShape(const VesselParameters& vessel);

}  // namespace restenosis
