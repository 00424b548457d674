#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/scene/SceneOverride.h"

namespace restenosis {

/// The command line's way to name a scene: the file, and `--set` for single values.
struct SceneArguments {
  std::string file;
  std::vector<std::string> overrides;  ///< of `--set`
  std::vector<SceneOverride> others;   ///< applied after these
  std::optional<std::string> flow;     ///< backend instead of the scene's

  void addTo(CLI::App& command);
  /// `--flow` too, the short way to another backend.
  void addFlowTo(CLI::App& command);
  /// Reads the scene; prints what is wrong with it to standard error and returns nothing.
  std::optional<Scene> read() const;
};

}  // namespace restenosis
