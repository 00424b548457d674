#include "bridge/coupling/parts/LumenPart.h"

#include "bridge/surface/LumenSurface.h"

namespace restenosis {

Verdict LumenPart::inputsChanged(const Instant&) const {
  const bool changed = world_.changes.changedSince(name(), Quantity::agentPositions);
  if (changed || world_.lumen.closed) return Verdict::run();
  return Verdict::skip("no agent moved");
}

void LumenPart::run(const Instant& now) {
  world_.updateLumen();
  world_.changes.markRead(name(), Quantity::agentPositions);
  world_.changes.touch(Quantity::lumen);
  if (world_.lumen.closed && looksForOcclusion(now)) throw Occluded();
}

}  // namespace restenosis
