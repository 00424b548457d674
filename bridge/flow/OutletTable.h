#pragma once

#include <filesystem>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "tissue/parameters/CsvLines.h"

namespace restenosis {

/// Reads a table of outlets: the line `solid,share` or `solid,resistance`, then a line for each of two
/// outlets or more, the name of its solid in the lumen's surface and a positive number: the share of the flow
/// rate, which together are 1 within 0.001, or the resistance of what lies behind [Pa s/m^3]. Lines may be
/// empty or comments that begin with #. The outlets are sorted by name, as those of a loaded lumen are; their
/// shares are exactly 1 together. Throws TableError.
std::vector<Outlet> readOutlets(const std::filesystem::path& file);

}  // namespace restenosis
