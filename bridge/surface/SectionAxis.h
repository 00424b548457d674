#pragma once

#include "bridge/surface/Centreline.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The axis of a lumen that is bent, by sections: from the inlet's centre on, half a radius at a time, the
/// lumen is cut square to the way that an arc through the last two centres takes, and the centre of the
/// section is the next point. A smooth curve through all of them ends in the outlet's centre. The lumen must
/// be closed, with planar ends. Throws std::runtime_error, saying where, where there is no section to go on
/// with.
Centreline axisBySections(const TriSurface& lumen);

/// A lumen in the straight coordinates of its axis: the inlet in the plane z = 0, the outlet where the axis
/// ends.
TriSurface straightened(const TriSurface& lumen, const Centreline& axis);

}  // namespace restenosis
