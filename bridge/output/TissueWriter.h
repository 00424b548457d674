#pragma once

#include <filesystem>

#include "bridge/surface/Centreline.h"
#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Writes the agents as points [m] with the arrays radius [m], kind (0 smc, 1 iel, 2 eel, 3 strut), state (0
/// g0, 1 g1, 2 sg2m), stress (minus a third of the virial's trace) [Pa], NO [nmol/mm^3], wss [Pa],
/// generation, id, and one array of 0 and 1 for each flag. In ParaView: representation "Point Gaussian" with
/// radius from the array of that name. All is bent along an axis that is given (bendPolyData). `time` is in
/// s. Throws WriteFailed.
void writeTissue(const std::filesystem::path& file, const AgentStore& agents, double time,
                 const Centreline* axis = nullptr);

}  // namespace restenosis
