#pragma once

#include <filesystem>

#include "TriSurface.h"

namespace restenosis {

/// Writes the lumen's wall and struts as an STL file in mm with the solids "wall" and, if there are any,
/// "strut". The ends are left out; the rims are carried on beyond them along z by `overshoot` [m], so that a
/// mesher that cuts the lumen in the planes of its ends gets planar ends. Throws std::runtime_error where the
/// file cannot be written.
void writeLumenStl(const TriSurface& lumen, double overshoot, const std::filesystem::path& file);

}  // namespace restenosis
