#include "bridge/coupling/parts/ExposurePart.h"

namespace restenosis {

Verdict ExposurePart::inputsChanged(const Instant&) const {
  if (world_.changes.changedSince(name(), Quantity::agentPositions)) return Verdict::run();
  return Verdict::skip("no agent moved");
}

void ExposurePart::run(const Instant&) {
  auto measurement = world_.timer.measure("biology");
  world_.biology.updateInhibition(world_.wall.agents);
  world_.changes.markRead(name(), Quantity::agentPositions);
  world_.changes.touch(Quantity::exposure);
}

}  // namespace restenosis
