#pragma once

#include <filesystem>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Where a patch's samples of the stress lie: a folder for each time [s], the earliest first.
std::vector<std::filesystem::path> sampleFolders(const std::filesystem::path& patch);

/// Reads one sample of a patch, a list of a vector for each face. Throws std::runtime_error where it cannot
/// be read or a number is not finite.
std::vector<Vec3> readWallSample(const std::filesystem::path& file);

}  // namespace restenosis
