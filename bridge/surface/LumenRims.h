#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/LumenCap.h"

namespace restenosis {

using Rim = std::vector<std::uint32_t>;  ///< vertices in order

/// The open rims of a surface whose triangles are oriented alike, each of which is an end. Throws
/// std::runtime_error, saying where and how wide, for holes (`holesAmong`), and for rims that touch or do not
/// close.
std::vector<Rim> endRims(const TriSurface& surface, const SurfaceEdges& edges);

/// Closes an open rim by a fan about a point, oriented as the surface.
LumenCap closeByFan(TriSurface& surface, const Rim& rim, const Vec3& centre);

/// Closes an open rim by a fan about its centre, all in the rim's plane, oriented as the surface. Throws
/// std::runtime_error if the rim is not planar (`lumenEndPlanarity`).
LumenCap closeRim(TriSurface& surface, const Rim& rim);

/// Turns all normals of a closed surface outwards.
void turnOutwards(TriSurface& surface);

}  // namespace restenosis
