#include "bridge/app/CheckCommand.h"

#include <iostream>
#include <memory>

#include "bridge/app/ExitStatus.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/coupling/Plan.h"

namespace restenosis {

void addCheckCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "validate a scene and print the plan; runs nothing");
  struct Arguments {
    SceneArguments scene;
    bool json = false, quiet = false;
  };
  auto arguments = std::make_shared<Arguments>();
  arguments->scene.addTo(*command);
  arguments->scene.addFlowTo(*command);
  auto* json = command->add_flag("--json", arguments->json, "the plan as JSON, for programs");
  command->add_flag("-q,--quiet", arguments->quiet, "say only what is wrong")->excludes(json);
  command->callback([arguments, &status] {
    const auto scene = arguments->scene.read();
    if (!scene) {
      status = ExitStatus::wrongInput;
    } else if (!arguments->quiet) {
      std::cout << (arguments->json ? planJson(*scene) : planText(*scene));
    }
  });
}

}  // namespace restenosis
