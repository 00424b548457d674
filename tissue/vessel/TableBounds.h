#pragma once

#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Bounds of a table's values: wide enough for every wall and stent of a run, narrow enough to detect a
/// mistaken unit or a misplaced line.
namespace tableBounds {

/// Distance of the wall's outer face from the axis [m].
inline double outerRadius(const VesselParameters& vessel) {
  return vessel.lumenDiameter / 2 + vessel.wallThickness;
}

/// Largest distance from the axis at which a sphere may begin [m]. A wall that keeps its volume and is
/// pressed in as far as a stent may go, by its own thickness, reaches sqrt(2) times its outer radius; 1.5 is
/// assumed.
inline double farthest(const VesselParameters& vessel) { return 1.5 * outerRadius(vessel); }

/// Least radius of a strut's sphere [m]: that of the smallest cells a scene may have. Assumed; no strut of a
/// design is thinner than 10 um.
constexpr double leastStrutRadius = 1e-6;

}  // namespace tableBounds
}  // namespace restenosis
