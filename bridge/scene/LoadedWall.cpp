#include "bridge/scene/LoadedWall.h"

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/SectionAxis.h"
#include "bridge/surface/VesselAxis.h"
#include "bridge/surface/WallOutwards.h"

namespace restenosis {

bool hasOwnLumen(const VesselParameters& vessel) {
  return !vessel.lumenSurface.empty() || hasRadiiAlong(vessel);
}

TriSurface lumenOfTissue(const VesselParameters& vessel) {
  if (vessel.lumenSurface.empty()) return straightLumen(vessel);
  const TriSurface lumen = loadLumen(vessel);
  requireLumenWithPlanarEnds(lumen);
  if (vessel.lumenSurfaceIsBent) {
    TriSurface straight = straightened(lumen, axisBySections(lumen));
    requireLumen(straight);
    return straight;
  }
  return movedAlongZ(lumen, *frameAlongZ(lumen));
}

WallShape loadedWallShape(const VesselParameters& vessel) {
  return wallOutwards(lumenOfTissue(vessel), vessel);
}

}  // namespace restenosis
