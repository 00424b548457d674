#include "bridge/coupling/parts/WallShearPart.h"

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/sampling/ShearResponse.h"
#include "bridge/sampling/WssSampling.h"

namespace restenosis {

std::vector<PlannedPart> WallShearPart::explain(const Scene&) { return {}; }

std::unique_ptr<WallShearPart> WallShearPart::make(const PartContext& context) {
  const World& world = context.world;
  if (!world.scene.flow || world.scene.flow->backend == flowBackendNames::none) return nullptr;
  if (!world.biology.rules().readWss()) return nullptr;
  return std::make_unique<WallShearPart>(context.world);
}

Verdict WallShearPart::inputsChanged(const Instant&) const {
  if (!world_.flow.last) return Verdict::skip("no flow solved yet");
  for (const Quantity quantity : reads()) {
    if (world_.changes.changedSince(name(), quantity)) return Verdict::run();
  }
  return Verdict::skip("neither the flow nor the cells changed");
}

void WallShearPart::run(const Instant&) {
  if (!world_.flow.last) return;
  auto measurement = world_.timer.measure("biology");
  world_.wall.agents.wss = sampleWss(world_.wall.agents, world_.flow.last->wall).wss;
  if (world_.scene.coupling.stressUpdate == "firstOrder") followLumen();
  for (const Quantity quantity : reads()) world_.changes.markRead(name(), quantity);
  world_.changes.touch(Quantity::wallShearStress);
}

void WallShearPart::followLumen() {
  const LumenState& lumen = world_.lumen;
  if (!lumen.atLastFlow.comparable(lumen.present) ||
      displacement(lumen.atLastFlow, lumen.present).largest == 0)
    return;
  const FlowConditions conditions = world_.scene.flow->conditions(world_.scene.vessel.lumenDiameter);
  const ShearResponse response(lumen.atLastFlow, lumen.present, conditions.drive,
                               world_.scene.coupling.surfaceResolution);
  AgentStore& agents = world_.wall.agents;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < agents.size(); ++i)
    if (agents.wss[i] > 0) agents.wss[i] *= response.factorAt(agents.position(i));
}

}  // namespace restenosis
