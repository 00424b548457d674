#pragma once

#include <filesystem>
#include <vector>

#include "Scene.h"

namespace restenosis {

/// The files that a scene names beside its own.
std::vector<std::filesystem::path> sceneFiles(const Scene& scene);

}  // namespace restenosis
