#pragma once

#include <memory>

#include "bridge/surface/Centreline.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The axis of a vessel that is bent, from its inlet to its outlet and so much further at either end [m];
/// null of a straight one.
std::shared_ptr<const Centreline> vesselAxis(const VesselParameters& vessel, double beyond = 0.0);

/// A surface about the z axis, bent along an axis.
TriSurface bentAlong(const Centreline& axis, const TriSurface& straight);

}  // namespace restenosis
