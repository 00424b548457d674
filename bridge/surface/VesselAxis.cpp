#include "bridge/surface/VesselAxis.h"

namespace restenosis {

std::shared_ptr<const Centreline> vesselAxis(const VesselParameters& vessel, double beyond) {
  if (!vessel.isBent()) return nullptr;
  return std::make_shared<const Centreline>(
      Centreline::arc(vessel.curvatureRadius, -beyond, vessel.length + beyond));
}

TriSurface bentAlong(const Centreline& axis, const TriSurface& straight) {
  TriSurface bent = straight;
  for (Vec3& vertex : bent.vertices) vertex = axis.toBent(vertex);
  return bent;
}

}  // namespace restenosis
