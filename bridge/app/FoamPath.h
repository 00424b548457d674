#pragma once

#include <filesystem>

#include "FoamRequirements.h"
#include "ResultsFolder.h"

namespace restenosis {

/// Throws FolderRefused where OpenFOAM cannot work below this folder of results.
inline void requireFoamPath(const std::filesystem::path& folder) {
  if (const std::string obstacle = unusableFoamPath(folder); !obstacle.empty())
    throw FolderRefused(obstacle + ": choose another folder with -o");
}

}  // namespace restenosis
