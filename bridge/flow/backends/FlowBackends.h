#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamSettings.h"
#include "bridge/flow/lbm/LbmSettings.h"

namespace restenosis {

/// What a backend may need beside the surface and the conditions.
struct FlowBackendOptions {
  std::string fidelity = "standard";                 ///< draft, standard or reference
  std::optional<FoamSettings> foam = std::nullopt;   ///< instead of those of the fidelity
  std::optional<LbmSettings> lbm = std::nullopt;     ///< the same
  double straightEnds = 0.0;                         ///< FlowParameters::straightEnds [m]
  bool keepVelocities = false;                       ///< for FlowBackend::velocities; costs memory
  bool moveMesh = false;                             ///< rather than mesh each lumen anew (foam)
  int ranks = 1;                                     ///< processes that may work on one flow
  const std::atomic<bool>* stopRequested = nullptr;  ///< once true, a solve under way ends by FlowFailed
  std::function<void(const std::string& stage)> onStage = {};  ///< told what a solve is about to do (foam)
};

/// The backends, each made by its name.
struct FlowBackendEntry {
  std::string_view name;
  std::unique_ptr<FlowBackend> (*make)(const FlowBackendOptions& options);
};

/// The table of all backends; a new one is a line here and a name in FlowBackendNames.h.
const std::vector<FlowBackendEntry>& flowBackends();

/// The backend of this name; null for "none". Throws std::invalid_argument, with the valid names, for others.
std::unique_ptr<FlowBackend> makeFlowBackend(std::string_view name, const FlowBackendOptions& options);

}  // namespace restenosis
