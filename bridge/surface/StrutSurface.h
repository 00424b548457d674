#pragma once

#include <span>

#include "bridge/surface/TriSurface.h"
#include "tissue/stent/Stent.h"

namespace restenosis {

/// The closed surface of struts, with planar caps where a vessel of this length [m] ends, normals out of the
/// struts. All regions are `strut`. It is taken from their distance on a grid with nodes `resolution` [m]
/// apart, which bevels edges by about half of that. Without struts within the vessel it is empty.
TriSurface strutSurface(std::span<const StrutSegment> struts, double length, double resolution);

}  // namespace restenosis
