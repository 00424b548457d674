#include "bridge/app/CheckCommand.h"

#include <iostream>
#include <memory>

#include "bridge/app/ExitStatus.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/coupling/Plan.h"

namespace restenosis {

void addCheckCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "validate a scene and print the plan; runs nothing");
  auto arguments = std::make_shared<SceneArguments>();
  arguments->addTo(*command);
  arguments->addFlowTo(*command);
  command->callback([arguments, &status] {
    const auto scene = arguments->read();
    if (scene) {
      std::cout << planText(*scene);
    } else {
      status = ExitStatus::wrongInput;
    }
  });
}

}  // namespace restenosis
