#pragma once

#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// Whether the wall is built around a lumen that is no cylinder: that of `vessel.lumenSurface`, or of a
/// centreline with radii.
bool hasOwnLumen(const VesselParameters& vessel);

/// The lumen of `vessel.lumenSurface`, or of a centreline's radii, in the coordinates of the tissue that is
/// built around it: the inlet in the plane z = 0 with its centre in the origin, the outlet parallel to it. A
/// bent surface is straightened. Throws std::runtime_error where it cannot be read, std::invalid_argument
/// where it is no lumen then.
TriSurface lumenOfTissue(const VesselParameters& vessel);

/// The shape of the wall around it. Throws as lumenOfTissue and wallOutwards do.
WallShape loadedWallShape(const VesselParameters& vessel);

}  // namespace restenosis
