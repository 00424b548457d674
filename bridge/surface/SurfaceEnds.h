#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Two vertices that only one triangle joins, in that triangle's direction.
using OpenEdge = std::array<std::uint32_t, 2>;

/// How the triangles of a surface meet.
struct SurfaceEdges {
  static constexpr std::uint32_t none = 0xffffffff;
  /// By triangle and side (from corner k to the next): the triangle beyond, or `none`.
  std::vector<std::array<std::uint32_t, 3>> beyond;
  std::vector<OpenEdge> open;
  std::size_t crowded = 0;             ///< edges of more than two triangles
  std::vector<OpenEdge> crowdedEdges;  ///< those, each in the direction of one of its triangles
  std::size_t opposed = 0;             ///< edges whose two triangles run along them in the same direction
};
SurfaceEdges surfaceEdges(const TriSurface& surface);

/// Chains of open edges that close, each as its vertices in order, none of them twice: rims that touch are
/// told apart. Throws std::runtime_error where a chain does not close.
std::vector<std::vector<std::uint32_t>> openRims(const std::vector<OpenEdge>& open);

/// Whether each open rim is a hole in a surface whose triangles are oriented alike, and not an end of it: the
/// surface goes on beside it in its plane. Over more than a tenth of a hole's length the surface turns by
/// less than the 30 degrees of a cap's rim, if the rim is closed by a flat cap; or the rim has no width. An
/// end's wall may be tapered by up to 60 degrees to its axis (all assumed). Size does not matter: what is a
/// small rim in a wide vessel is an end of a narrow one.
std::vector<bool> holesAmong(const TriSurface& surface, const SurfaceEdges& edges,
                             const std::vector<std::vector<std::uint32_t>>& rims);

/// A plane through vertices, and how well they keep to it.
struct FittedPlane {
  Vec3 centre = Vec3::Zero();  ///< of the vertices
  Vec3 normal = Vec3::Zero();  ///< unit vector, of either sign
  double departure = 0.0;      ///< of the vertex farthest from the plane [m]
};
FittedPlane fitPlane(const TriSurface& surface, const std::vector<std::uint32_t>& vertices);

/// The planar caps of a closed surface with outward normals: connected coplanar triangles that meet all
/// others at a convex edge of at least 30 degrees (assumed). The faces of a strut do not count: their edges
/// are concave, at least in part. Neither do the strips of a polygonal tube of 13 sides or more, which meet
/// at less.
std::vector<std::vector<std::uint32_t>> planarCaps(const TriSurface& surface, const SurfaceEdges& edges);

}  // namespace restenosis
