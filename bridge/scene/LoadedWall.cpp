#include "bridge/scene/LoadedWall.h"

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/WallOutwards.h"

namespace restenosis {

TriSurface lumenOfTissue(const VesselParameters& vessel) {
  const TriSurface lumen = loadLumen(vessel);
  requireLumenWithPlanarEnds(lumen);
  const auto frame = frameAlongZ(lumen);
  if (!frame) refuseLumen("tissue is built around a lumen between two parallel planes");
  return movedAlongZ(lumen, *frame);
}

WallShape loadedWallShape(const VesselParameters& vessel) {
  return wallOutwards(lumenOfTissue(vessel), vessel);
}

}  // namespace restenosis
