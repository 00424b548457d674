#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `tradeoff SCENE`: what accuracy costs in this scene.
void addTradeoffCommand(CLI::App& app, int& status);

}  // namespace restenosis
