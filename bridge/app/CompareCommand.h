#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `compare SCENE|DIR`: OpenFOAM and the lattice Boltzmann method in one lumen.
void addCompareCommand(CLI::App& app, int& status);

}  // namespace restenosis
