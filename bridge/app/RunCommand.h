#pragma once

#include <CLI/CLI.hpp>
#include <span>

namespace restenosis {

/// `run SCENE`: runs a scene into a results folder and names the files to open. `commandLine` is what the
/// user gave, for the words that go on with an interrupted run.
void addRunCommand(CLI::App& app, int& status, std::span<const char* const> commandLine);

}  // namespace restenosis
