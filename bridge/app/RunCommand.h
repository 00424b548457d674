#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `run SCENE`: runs a scene into a results folder and names the files to open.
void addRunCommand(CLI::App& app, int& status);

}  // namespace restenosis
