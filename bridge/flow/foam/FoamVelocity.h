#pragma once

#include <filesystem>
#include <vector>

#include "TriSurface.h"

namespace restenosis {

/// Velocity [m/s] at points [m] of the last time of a case in millimetres, interpolated from the cells to
/// their corners and from there; NaN outside the mesh. Throws std::runtime_error where the case cannot be
/// read.
std::vector<Vec3> foamVelocities(const std::filesystem::path& caseFolder, const std::vector<Vec3>& points);

}  // namespace restenosis
