#include "bridge/coupling/parts/NitricOxidePart.h"

namespace restenosis {

Verdict NitricOxidePart::needs(Quantity quantity, const Instant&) const {
  if (quantity != Quantity::wallShearStress) return Verdict::run();
  return Verdict::unless(world_.biology.rules().wssChangesNothingBecause(world_.wall.agents));
}

void NitricOxidePart::run(const Instant&) {
  auto measurement = world_.timer.measure("biology");
  world_.biology.updateNitricOxide(world_.wall.agents);
  world_.changes.touch(Quantity::nitricOxide);
}

}  // namespace restenosis
