#pragma once

#include <filesystem>

#include "bridge/flow/foam/LumenCase.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Writes the lumen as an STL file in metres with the solids "wall", if there are any "strut", and those of
/// the ends that are not cut, "inlet" and "outlet". Ends that are cut are left out; their rims are carried on
/// beyond them along z by `overshoot` [m], so that a mesher that cuts the lumen in the planes of its ends
/// gets planar ends. Where only the inlet is cut, the wall is closed behind it, so that the surface has an
/// inside. Throws WriteFailed.
void writeLumenStl(const TriSurface& lumen, LumenEnds ends, double overshoot,
                   const std::filesystem::path& file);

/// Writes the edges in which the ends that are not cut meet the wall as an OBJ file of lines in metres, for a
/// mesher that must keep them sharp. Throws WriteFailed.
void writeRims(const TriSurface& lumen, LumenEnds ends, const std::filesystem::path& file);

}  // namespace restenosis
