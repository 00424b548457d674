#include "bridge/flow/backends/FlowBackends.h"

#include <fmt/format.h>

#include "bridge/flow/DistalResistance.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/OutletResistances.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/flow/analytic/AnalyticBackend.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/lbm/LbmBackend.h"
#include "tissue/parameters/NameList.h"

namespace restenosis {

const std::vector<FlowBackendEntry>& flowBackends() {
  static const std::vector<FlowBackendEntry> table = {
      {flowBackendNames::foam,
       [](const FlowBackendOptions& options) -> std::unique_ptr<FlowBackend> {
         return std::make_unique<FoamBackend>(
             options.foam ? *options.foam : FoamSettings::forFidelity(options.fidelity),
             FoamExecution{.ranks = options.ranks,
                           .stopRequested = options.stopRequested,
                           .onProgram = options.onStage},
             options.moveMesh ? FoamBackend::Remeshing::onDemand : FoamBackend::Remeshing::always);
       }},
      {flowBackendNames::lbm,
       [](const FlowBackendOptions& options) -> std::unique_ptr<FlowBackend> {
         return std::make_unique<LbmBackend>(
             options.lbm ? *options.lbm : LbmSettings::forFidelity(options.fidelity), options.stopRequested,
             options.keepVelocities);
       }},
      {flowBackendNames::analytic,
       [](const FlowBackendOptions&) -> std::unique_ptr<FlowBackend> {
         return std::make_unique<AnalyticBackend>();
       }},
  };
  return table;
}

std::unique_ptr<FlowBackend> makeFlowBackend(std::string_view name, const FlowBackendOptions& options) {
  if (name == flowBackendNames::none) return nullptr;
  for (const auto& entry : flowBackends())
    if (entry.name == name) {
      auto backend = entry.make(options);
      if (options.straightEnds > 0.0)
        backend = std::make_unique<StraightEnds>(std::move(backend), options.straightEnds);
      backend = std::make_unique<OutletResistances>(std::move(backend));
      return std::make_unique<DistalResistance>(std::move(backend));
    }
  throw std::invalid_argument(fmt::format("there is no flow backend '{}'; valid names: {}", name,
                                          commaSeparated(flowBackendNames::all())));
}

}  // namespace restenosis
