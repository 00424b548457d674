#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `schema`: every key of a scene with unit, default, bounds and source.
void addSchemaCommand(CLI::App& app, int& status);

}  // namespace restenosis
