#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `report DIR...`: the page of a run again, or one of several runs and studies side by side.
void addReportCommand(CLI::App& app, int& status);

}  // namespace restenosis
