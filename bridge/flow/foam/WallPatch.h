#pragma once

#include <filesystem>
#include <vector>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// Reads a sampled wall patch (.vtp, face field wallShearStress in m^2/s^2) and appends its faces in
/// SI units. The solver's stress is kinematic and that of the wall on the fluid, so the traction on the wall
/// is -density * wallShearStress, of which the part in the face's plane is kept. Throws std::runtime_error
/// where the file cannot be read, has no faces or no such field, or where a stress is not finite.
void appendWallPatch(const std::filesystem::path& file, SurfaceRegion region, double density,
                     std::vector<WallFace>& faces);

}  // namespace restenosis
