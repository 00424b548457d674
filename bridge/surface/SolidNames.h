#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/surface/StlFile.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// What the name of a solid says that it is: nothing (empty), one thing, or several that it cannot be at
/// once.
///
/// Whole words count, in letters of any case, told apart by anything but letters, by digits and by capitals
/// within a word ("inlet1", "Inlet-Cap", "strut_2", "vesselInlet"): inlet, inflow; outlet, outflow; wall;
/// stent, strut; and their plurals. So "stented" is no stent. "in" and "out" count as the first or last word
/// of a name that says nothing else. Names of a place (lumen, vessel, artery, segment, section, region, zone)
/// are those of a wall, unless of its inlet or outlet; beside "stent" they make two things of it, as does
/// "in-stent".
std::vector<SurfaceRegion> meaningsOf(std::string_view name);

/// Solids for messages, by their numbers: "the solid 'wall'", "the solids 'a' and 'b'", "the solids 2 and 3",
/// which have no names, "9 solids ('a', 'b', 'c', ...)".
std::string shownSolids(const std::vector<std::string>& names, const std::vector<std::uint32_t>& solids);

/// The same of the solids that triangles belong to; triangles that the file does not have do not count. Empty
/// where the file is one solid without a name.
std::string shownSolids(const SurfaceSolids& file, std::span<const std::uint32_t> triangles);

}  // namespace restenosis
