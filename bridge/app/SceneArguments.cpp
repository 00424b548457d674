#include "bridge/app/SceneArguments.h"

#include <iostream>

#include "bridge/app/OptionChecks.h"
#include "bridge/scene/SceneReader.h"
#include "bridge/scene/Units.h"

namespace restenosis {

void SceneArguments::addTo(CLI::App& command) {
  command.add_option("SCENE", file, "scene file (TOML)")
      ->required()
      ->check(notEmpty("the name of a scene file (*.toml)"));
  command
      .add_option(
          "--set", overrides,
          "replace a value: SECTION.KEY=VALUE, as in --set scene.seed=2 --set \"scene.duration=3 d\"; "
          "SECTION=absent takes a section out, SECTION=present adds one with its defaults")
      ->allow_extra_args(false);
}

void SceneArguments::addFlowTo(CLI::App& command) {
  command.add_option("--flow", flow, "flow backend instead of the scene's: foam, lbm, analytic or none");
}

std::optional<Scene> SceneArguments::read() const {
  try {
    const Units units;
    std::vector<SceneOverride> all(overrides.begin(), overrides.end());
    all.insert(all.end(), others.begin(), others.end());
    if (flow) all.emplace_back("flow.backend=" + *flow, "--flow");
    return SceneReader(units).readFile(file, all);
  } catch (const SceneError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) std::cerr << toString(diagnostic) << '\n';
  }
  return std::nullopt;
}

}  // namespace restenosis
