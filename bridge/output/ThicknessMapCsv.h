#pragma once

#include <filesystem>

#include "bridge/surface/RadialMap.h"

namespace restenosis {

/// Writes the neointima by axial position and angle (model 10), a row for each ray of the maps, plane by
/// plane: z_mm, angle_deg (from the x axis towards the y axis), lumenRadius_um (from the vessel's axis to the
/// present lumen) and neointimaThickness_um (post-deployment radius minus present one; signed). The maps must
/// be `comparable`. Throws WriteFailed.
void writeThicknessMapCsv(const std::filesystem::path& file, const RadialMap& postDeployment,
                          const RadialMap& present);

}  // namespace restenosis
