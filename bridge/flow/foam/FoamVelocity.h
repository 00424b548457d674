#pragma once

#include <filesystem>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Velocity [m/s] at points [m] inside the lumen of a case, at its last time: that of a
/// quadratic function fitted to the nearest cells, so that the parabola of developed flow is met exactly.
/// Throws std::runtime_error where the case cannot be read.
std::vector<Vec3> foamVelocities(const std::filesystem::path& caseFolder, const std::vector<Vec3>& points);

}  // namespace restenosis
