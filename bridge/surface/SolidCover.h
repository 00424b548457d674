#pragma once

#include <vector>

#include "bridge/surface/DistanceField.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Balls inside a solid, along its surface, and what they leave out.
struct SolidCover {
  std::vector<Ball> balls;
  double tooThin = 0;  ///< share of the surface's area where no ball fits
};

/// Covers a solid by balls as the struts of designs are covered (`coverWithSpheres`): they lie inside the
/// closed surface, whose normals point outwards, flush with its faces, edges and corners, about one radius
/// apart. Pieces, which no edge joins, are covered each by itself, and may overlap, touch or enclose each
/// other: what any of them encloses is solid. None may pass through itself. Their radius is `largest`, or
/// half of the solid's thickness where that is less, but never below `least` [m]. What is thicker than two
/// balls is hollow. Looked at from a place of a face, the nearest ball is no more than about 0.3 of its
/// radius below the face, beside what any ball leaves free at an edge. The same bit for bit for any number of
/// threads.
SolidCover coverSolid(const TriSurface& solid, double largest, double least);

}  // namespace restenosis
