#pragma once

#include <string>
#include <vector>

#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// How many places a message about a loaded lumen lists.
constexpr std::size_t placesShown = 6;

/// Throws std::runtime_error: the lumen surface cannot be used, and why.
[[noreturn]] void refuseLumen(const std::string& reason);

/// A place [m] for people, in mm without the round-off of zeros.
std::string shownPlace(const Vec3& place);

/// Lengths and middles of edges for messages.
std::string shownEdges(const TriSurface& surface, const std::vector<OpenEdge>& edges);

}  // namespace restenosis
