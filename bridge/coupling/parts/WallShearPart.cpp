#include "WallShearPart.h"

#include "WssSampling.h"

namespace restenosis {

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
  for (const Quantity quantity : reads()) world_.changes.markRead(name(), quantity);
  world_.changes.touch(Quantity::wallShearStress);
}

}  // namespace restenosis
