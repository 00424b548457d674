#include "bridge/coupling/SceneFlow.h"

#include <utility>

#include "bridge/flow/LumenFrame.h"

namespace restenosis {

FlowBackendOptions flowBackendOptions(const PartContext& context) {
  const Scene& scene = context.run.scene;
  return {.fidelity = scene.scene.fidelity,
          .foam = scene.foam,
          .lbm = scene.lbm,
          .straightEnds = scene.flow->straightEnds,
          .moveMesh = scene.coupling.movesMesh(),
          .ranks = context.ranks,
          .stopRequested = context.stopRequested,
          .onStage = [&progress = context.run.progress](const std::string& stage) { progress.flow(stage); }};
}

std::unique_ptr<FlowBackend> flowBackendFor(const Scene& scene, std::string_view name,
                                            const FlowBackendOptions& options) {
  auto backend = makeFlowBackend(name, options);
  if (backend && scene.hasLoadedLumen()) backend = std::make_unique<AnyDirection>(std::move(backend));
  return backend;
}

}  // namespace restenosis
