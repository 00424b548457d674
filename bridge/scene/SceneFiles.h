#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "Scene.h"

namespace restenosis {

/// The files that a scene names beside its own, by "section.key".
std::map<std::string, std::filesystem::path> sceneFiles(const Scene& scene);

}  // namespace restenosis
