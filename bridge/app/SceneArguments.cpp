#include "SceneArguments.h"

#include <iostream>

#include "SceneReader.h"
#include "Units.h"

namespace restenosis {

void SceneArguments::addTo(CLI::App& command) {
  command.add_option("SCENE", file, "scene file (TOML)")->required();
  command
      .add_option(
          "--set", overrides,
          "replace a value: SECTION.KEY=VALUE, as in --set scene.seed=2 --set \"scene.duration=3 d\"; "
          "SECTION=absent takes a section out, SECTION=present adds one with its defaults")
      ->allow_extra_args(false);
}

std::optional<Scene> SceneArguments::read() const {
  try {
    const Units units;
    return SceneReader(units).readFile(file, overrides);
  } catch (const SceneError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) std::cerr << toString(diagnostic) << '\n';
  }
  return std::nullopt;
}

}  // namespace restenosis
