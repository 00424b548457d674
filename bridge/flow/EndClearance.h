#pragma once

#include <optional>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Looks for something that comes near the plane of an end without belonging to that end: another part of
/// the lumen that passes by, its other end, or the end's own wall where it turns back towards the plane. A
/// mesh that the plane cuts would take cells there for the end's.
///
/// The end's own wall is what hangs together with its rim within `depth` [m] of the plane and stays within a
/// cone of 60 degrees about it (assumed: as an end's wall may be tapered), widened by half of `depth`. What
/// lies over the end itself, such as tissue in the lumen, is not in the way.
///
/// Returns a place [m] where something else comes that near, or nothing. The lumen must pass
/// requireLumenWithPlanarEnds.
std::optional<Vec3> strangerNearEnd(const TriSurface& lumen, SurfaceRegion end, double depth);

}  // namespace restenosis
