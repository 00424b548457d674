#include "bridge/coupling/SceneFlow.h"

#include <cmath>
#include <utility>

#include "bridge/flow/BentVessel.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/surface/VesselAxis.h"

namespace restenosis {

namespace {

/// How far a chord of the bend may be from its arc [m] (assumed: a fraction of a cell).
constexpr double sagitta = 1e-6;

double chordOf(double radius) { return std::sqrt(8 * radius * sagitta); }

/// Straight pieces of an end: it goes on along an arc, and straight behind any other axis.
int endRings(const VesselParameters& vessel, double length) {
  return vessel.curvatureRadius > 0 ? static_cast<int>(std::ceil(length / chordOf(vessel.curvatureRadius)))
                                    : 1;
}

}  // namespace

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
  // The analytic one reads radii about the axis, which a bent vessel keeps
  auto axis = name == flowBackendNames::analytic ? nullptr : vesselAxis(scene.vessel, options.straightEnds);
  FlowBackendOptions own = options;
  if (axis) own.straightEnds = 0;
  auto backend = makeFlowBackend(name, own);
  if (!backend) return backend;
  if (scene.hasLoadedLumen() || axis) backend = std::make_unique<AnyDirection>(std::move(backend));
  if (axis) backend = std::make_unique<BentVessel>(std::move(backend), std::move(axis));
  // They go on along the bend
  if (own.straightEnds < options.straightEnds)
    backend = std::make_unique<StraightEnds>(std::move(backend), options.straightEnds,
                                             endRings(scene.vessel, options.straightEnds));
  return backend;
}

}  // namespace restenosis
