#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// Adds `--ranks`, which sets `ranks`, and `--launcher`, which is what starts them: it sets the variable of
/// the environment of the same meaning (MpiLauncher.h).
void addRankOptions(CLI::App& command, int& ranks);

}  // namespace restenosis
