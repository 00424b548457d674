#include "bridge/coupling/parts/WallShearPart.h"

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/sampling/ShearResponse.h"
#include "bridge/sampling/WssSampling.h"

namespace restenosis {

std::vector<PlannedPart> WallShearPart::explain(const Scene&) { return {}; }

std::unique_ptr<WallShearPart> WallShearPart::make(const PartContext& context) {
  RunState& run = context.run;
  if (!run.scene.flow || run.scene.flow->backend == flowBackendNames::none) return nullptr;
  if (!run.biology.rules().readWss()) return nullptr;
  return std::make_unique<WallShearPart>(run.quantities, run.scene, run.timer);
}

Verdict WallShearPart::inputsChanged(const Instant&) const {
  if (!flow_->last) return Verdict::skip("no flow solved yet");
  return hasNewInput() ? Verdict::run() : Verdict::skip("neither the flow nor the cells changed");
}

void WallShearPart::run(const Instant&) {
  if (!flow_->last) return;
  auto measurement = timer_.measure("biology");
  stress_.change([&](AgentStore& agents) {
    agents.wss = sampleWss(agents, flow_->last->wall).wss;
    if (scene_.coupling.stressFollowsLumen()) followLumen(agents);
  });
}

void WallShearPart::followLumen(AgentStore& agents) const {
  const RadialMap &solved = flow_->lumen, &present = lumen_->present;
  if (!solved.comparable(present) || displacement(solved, present).largest == 0) return;
  const FlowConditions conditions = scene_.flow->conditions(scene_.vessel.lumenDiameter);
  const ShearResponse response(solved, present, conditions.drive, scene_.coupling.surfaceResolution);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < agents.size(); ++i)
    if (agents.wss[i] > 0) agents.wss[i] *= response.factorAt(agents.position(i));
}

}  // namespace restenosis
