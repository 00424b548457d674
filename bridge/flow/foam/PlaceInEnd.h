#pragma once

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A place well inside the end that carries this region [m]: its centroid, or, where that lies outside of it
/// (in an annulus, say) or near its rim, the middle of a triangle that is farthest from the rim. Throws
/// std::invalid_argument where there is no such end.
Vec3 placeInEnd(const TriSurface& lumen, SurfaceRegion end);

}  // namespace restenosis
