#include "bridge/coupling/parts/EndotheliumPart.h"

namespace restenosis {

Verdict EndotheliumPart::inputsChanged(const Instant& now) const {
  if (now.time >= world_.biology.endotheliumOnset()) return Verdict::run();
  return Verdict::skip("endothelium has not begun to return");
}

void EndotheliumPart::run(const Instant& now) {
  auto measurement = world_.timer.measure("biology");
  world_.biology.updateEndothelium(world_.wall.agents, now.time);
  world_.changes.touch(Quantity::coverage);
}

}  // namespace restenosis
