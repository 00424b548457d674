#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Where a surface passes through itself.
struct SurfaceCrossings {
  std::size_t edges = 0;      ///< that go through a triangle
  Vec3 place = Vec3::Zero();  ///< where the first of them does [m], if there is any
};

/// The edges of a surface that go through a triangle that has no corner with them in common, and belongs to
/// the same piece of `pieceOf` (one number a triangle). Both ends of the edge must lie beyond the triangle's
/// plane, on either side, and the place inside its sides, by more than an STL file's rounding and what makes
/// vertices one; or the edge must meet a side far from the ends of both. So surfaces that touch, slivers, and
/// triangles that rounding has folded do not count. Triangles that overlap in one plane do not cross. The
/// same for any number of threads.
SurfaceCrossings surfaceCrossings(const TriSurface& surface, const std::vector<std::uint32_t>& pieceOf);

}  // namespace restenosis
