#pragma once

#include <filesystem>
#include <vector>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// A face of a sampled wall patch.
struct PatchFace {
  Vec3 centre, areaVector;  ///< [m], [m^2]
  Vec3 shearStress;         ///< as OpenFOAM has it [m^2/s^2]

  /// The traction on the wall [Pa] of a wallShearStress [m^2/s^2] on this face. The solver's stress is
  /// kinematic and that of the wall on the fluid, so it is -density * wallShearStress, of which the part in
  /// the face's plane is kept. The face must have an area.
  Vec3 traction(double density, const Vec3& wallShearStress) const;
};

/// Reads a sampled wall patch (.vtp, face field wallShearStress). Throws std::runtime_error where the file
/// cannot be read, has no faces or no such field, or where a stress is not finite.
std::vector<PatchFace> readWallPatch(const std::filesystem::path& file);

/// Appends the faces of a patch that have an area, with their tractions. Throws as readWallPatch does.
void appendWallPatch(const std::filesystem::path& file, SurfaceRegion region, double density,
                     std::vector<WallFace>& faces);

}  // namespace restenosis
