#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `check SCENE`: validates, and prints which parts would run, which would not and why. Runs nothing.
void addCheckCommand(CLI::App& app, int& status);

}  // namespace restenosis
