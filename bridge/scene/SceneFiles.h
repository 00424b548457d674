#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// The files that a scene names beside its own, by "section.key".
std::map<std::string, std::filesystem::path> sceneFiles(const Scene& scene);

}  // namespace restenosis
