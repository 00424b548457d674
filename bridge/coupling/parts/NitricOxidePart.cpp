#include "bridge/coupling/parts/NitricOxidePart.h"

#include "bridge/coupling/StressReaders.h"

namespace restenosis {

Verdict NitricOxidePart::needs(Quantity quantity, const Instant&) const {
  if (quantity != Quantity::wallShearStress) return Verdict::run();
  const AgentStore& agents = world_.wall.agents;
  bool anyCovered = false;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != AgentKind::smc || !agents.has(i, covered)) continue;
    anyCovered = true;
    if (readsStress(agents, i)) return Verdict::run();
  }
  return Verdict::skip(anyCovered ? "every covered cell rests or divides whatever its wall shear stress"
                                  : "no cell is covered by endothelium");
}

void NitricOxidePart::run(const Instant&) {
  auto measurement = world_.timer.measure("biology");
  world_.biology.updateNitricOxide(world_.wall.agents);
  world_.changes.touch(Quantity::nitricOxide);
}

}  // namespace restenosis
