#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/scene/Diagnostic.h"
#include "bridge/scene/Scene.h"
#include "bridge/scene/SceneOverride.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// Reads scenes: TOML, with every quantity in quotes with its unit. A scene is returned only if nothing is
/// wrong with it; otherwise SceneError carries every finding with its place. Nothing is written.
///
/// `overrides` are applied in order before anything is checked.
class SceneReader {
 public:
  explicit SceneReader(const Units& units) : units_(units) {}

  /// Throws SceneError, also when the file cannot be read.
  Scene readFile(const std::filesystem::path& file, const std::vector<SceneOverride>& overrides = {}) const;

  /// The same for a text; `file` is what messages name, gives the scene its name, and is where relative paths
  /// start.
  Scene readText(std::string_view toml, const std::filesystem::path& file,
                 const std::vector<SceneOverride>& overrides = {}) const;

 private:
  const Units& units_;
};

}  // namespace restenosis
