#pragma once

#include <optional>
#include <vector>

#include "bridge/surface/LumenCap.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {

/// What the name of each solid says that it is (`meaningsOf`); nothing of a solid that is all of the file,
/// but that it is a strut. Throws std::runtime_error, naming the solid and its place, where one with
/// triangles says several things at once.
std::vector<std::optional<SurfaceRegion>> namedRegions(const SurfaceSolids& file);

/// The ends that solids are named to be. Throws std::runtime_error, naming the solids, with their size and
/// place, where what is named one end is none: in several pieces, or not planar (`lumenEndPlanarity`). The
/// inlet comes first. Of several outlets each is a solid, and they are sorted by name.
std::vector<LumenCap> namedEnds(const SurfaceSolids& file,
                                const std::vector<std::optional<SurfaceRegion>>& regions,
                                const SurfaceEdges& edges, Outlets outlets = Outlets::one);

/// How large triangles are and where, for messages: "576 triangles of 11.3 mm2 from (0, 0, 0) to (1, 1, 2)
/// mm".
std::string shownExtent(const TriSurface& surface, const std::vector<std::uint32_t>& triangles);

}  // namespace restenosis
