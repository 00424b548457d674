#pragma once

#include <array>

#include "bridge/flow/foam/BackgroundBlock.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Two places inside a lumen that tell the mesher where the lumen is, the better one first; the same twice
/// where only one was found.
///
/// The mesher keeps what hangs together with the cell that holds the place, and takes a cell for inside by
/// its centre. Each place is therefore such that whatever cell the mesher makes there, halved `core` to
/// `finest` times, has its centre inside the lumen and no wall between the two; it lies on no face of any.
/// Where the lumen has room, the place is farther from the surface than a cell of the core is wide.
///
/// The lumen must be closed, its normals outwards.
std::array<Vec3, 2> insidePoints(const TriSurface& lumen, const BackgroundBlock& block, int core, int finest);

}  // namespace restenosis
