#pragma once

#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Bounds of what a table may hold, wide enough for every wall and stent that a run can come to, and narrow
/// enough for a mistaken unit or a misplaced row to be told.
namespace tableBounds {

/// Distance of the wall's outer face from the axis [m].
inline double outerRadius(const VesselParameters& vessel) {
  return vessel.lumenDiameter / 2 + vessel.wallThickness;
}

/// How far from the axis anything of a table may begin [m]. A wall that keeps its volume and is pressed in as
/// far as a stent may go, by its own thickness, reaches sqrt(2) times its outer radius; 1.5 is assumed.
inline double farthest(const VesselParameters& vessel) { return 1.5 * outerRadius(vessel); }

/// Radius of the least sphere of a strut [m]: that of the smallest cells a scene may have; assumed, no strut
/// of a design is thinner than 10 um.
constexpr double leastStrutRadius = 1e-6;

}  // namespace tableBounds
}  // namespace restenosis
