#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bridge/flow/lbm/D3Q19.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Where a line of lattice nodes passes through a surface.
struct SurfaceCrossing {
  std::int32_t p, q;       ///< the line: see LinesAlong
  double t;                ///< where along the line, in steps of its direction
  std::uint32_t triangle;  ///< of the surface
};

/// The lattice lines along one direction: the nodes base(p, q) + t * direction, with base in the plane where
/// the direction's leading coordinate (the first that is not zero) is 0 and p, q the other two coordinates
/// in cyclic order.
struct LinesAlong {
  explicit LinesAlong(const d3q19::Step& direction);
  /// The node at step t of line (p, q).
  d3q19::Step node(std::int32_t p, std::int32_t q, std::int32_t t) const {
    d3q19::Step n{};
    n[leading] = t * direction[leading];
    n[second] = p + t * direction[second];
    n[third] = q + t * direction[third];
    return n;
  }
  d3q19::Step direction;
  std::size_t leading, second, third;
};

/// All crossings of lattice lines along `direction`, whose leading component must be +1, with a surface given
/// by vertices in lattice units (nodes at whole numbers) and triangles; sorted by line, then along it.
///
/// Triangles are projected along the direction and tested against the lines by the signs of edge functions,
/// each evaluated in the same way for both triangles of an edge and with ties broken as if the lines were
/// moved by an infinitesimal amount. So a line meets a closed surface an even number of times, also where it
/// runs through a vertex, along an edge or within a triangle.
std::vector<SurfaceCrossing> crossings(std::span<const Vec3> vertices,
                                       std::span<const std::array<std::uint32_t, 3>> triangles,
                                       const d3q19::Step& direction);

}  // namespace restenosis
