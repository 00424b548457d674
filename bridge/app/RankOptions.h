#pragma once

#include <CLI/CLI.hpp>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// Adds `--ranks`, which sets `ranks`, and `--launcher`, which is what starts them: it sets the variable of
/// the environment of the same meaning (MpiLauncher.h). `ranks` stays 0 where none is asked for.
void addRankOptions(CLI::App& command, int& ranks);

/// Processes of OpenFOAM's mesher and solver: as many as asked for, or where that is 0, two where the scene's
/// mesh is large enough to gain by them. It goes by the scene alone, so that the digest of its results does
/// not depend on how many cores a machine has.
int rankCount(const Scene& scene, int askedFor);

}  // namespace restenosis
