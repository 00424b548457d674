#include "LumenPart.h"

namespace restenosis {

Verdict LumenPart::inputsChanged(const Instant&) const {
  if (world_.changes.changedSince(name(), Quantity::agentPositions)) return Verdict::run();
  return Verdict::skip("no agent moved");
}

void LumenPart::run(const Instant&) {
  world_.updateLumen();
  world_.changes.markRead(name(), Quantity::agentPositions);
  world_.changes.touch(Quantity::lumen);
}

}  // namespace restenosis
