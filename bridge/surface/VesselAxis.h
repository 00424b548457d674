#pragma once

#include <functional>
#include <memory>

#include "bridge/surface/Centreline.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The axis of a vessel that is bent, from its inlet to its outlet and, on an arc, so much further at either
/// end [m]; null of a straight one. That of a bent surface is found (axisBySections). Throws
/// std::runtime_error for a file that cannot be used.
std::shared_ptr<const Centreline> vesselAxis(const VesselParameters& vessel, double beyond = 0.0);

/// The least radius of curvature of that axis [m]; infinite of a straight one.
double sharpestRadius(const VesselParameters& vessel);

/// The radius of the undeformed lumen [m] by place along the axis [m]: what a centreline has as radii, on
/// straight lines from point to point, or that of a cylinder (cylinderRadius).
std::function<double(double)> lumenRadius(const VesselParameters& vessel);

/// Whether the vessel's centreline has radii of its own.
bool hasRadiiAlong(const VesselParameters& vessel);

/// The lumen without tissue about the z axis, as long as the vessel: cylinderSurface with that radius.
TriSurface straightLumen(const VesselParameters& vessel);

/// A surface about the z axis, bent along an axis.
TriSurface bentAlong(const Centreline& axis, const TriSurface& straight);

}  // namespace restenosis
