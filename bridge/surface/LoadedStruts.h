#pragma once

#include <filesystem>
#include <string>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Reads the surface of a stent's struts from a surface file (SurfaceFile.h), in units of `metresPerUnit`
/// [m]: one or several closed pieces. Normals are turned outwards, piece by piece, whatever they were, so
/// that what a piece encloses is strut. All regions are `strut`.
///
/// Throws std::runtime_error, which names the file and says what is wrong, where it cannot be read, has
/// holes, or has edges of more than two triangles or pieces that enclose nothing, or beside solids named as
/// struts has others named as wall or ends (`meaningsOf`).
TriSurface loadStruts(const std::filesystem::path& file, double metresPerUnit);

/// What such a file holds: how many pieces, their volume, area and place, and the solids that they come from.
/// Throws as loadStruts does.
std::string describeStruts(const std::filesystem::path& file, double metresPerUnit);

}  // namespace restenosis
