#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A table of points that cannot be used; `what()` names the file and the line.
struct ProbeTableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads points [m] from a CSV table whose first line is "x_mm,y_mm,z_mm". Empty lines and what follows a #
/// are left out. Throws ProbeTableError.
std::vector<Vec3> readProbes(const std::filesystem::path& file);

}  // namespace restenosis
