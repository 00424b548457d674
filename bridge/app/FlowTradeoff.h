#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "bridge/app/SceneArguments.h"
#include "bridge/output/TradeoffRows.h"

namespace restenosis {

/// What a sweep may use of the machine.
struct TradeoffOptions {
  int threads = 1;
  int ranks = 0;  ///< processes of OpenFOAM, or 0: as many as suit the scene
  const std::atomic<bool>* stopRequested = nullptr;
};

/// The flow in one lumen, that of the scene just after deployment, by OpenFOAM and the lattice Boltzmann
/// method at every fidelity, and by Poiseuille's law where it does not hold: seconds for mesh and flow, and
/// the wall shear stress's relative L2 difference from Poiseuille's law where it holds, else from OpenFOAM at
/// `reference` (on the wall, struts and ends left out). A flow that fails is named and left out. Throws what
/// Run throws, and FlowFailed where the reference fails.
std::vector<TradeoffRow> flowTradeoff(const SceneArguments& scene, const std::filesystem::path& folder,
                                      const TradeoffOptions& options);

}  // namespace restenosis
