#pragma once

#include <filesystem>
#include <vector>

#include "bridge/surface/TriSurface.h"
#include "tissue/parameters/CsvLines.h"

namespace restenosis {

/// Reads points [m] from a CSV table whose first line is "x_mm,y_mm,z_mm". Empty lines and what follows a #
/// are left out. Throws TableError.
std::vector<Vec3> readProbes(const std::filesystem::path& file);

}  // namespace restenosis
