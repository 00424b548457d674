#include "CyclePart.h"

#include <algorithm>

namespace restenosis {

void CyclePart::run(const Instant& now) {
  auto measurement = world_.timer.measure("biology");
  AgentStore& agents = world_.wall.agents;
  const auto radiusBefore = agents.radius;
  const CycleReport report = world_.biology.advanceCycle(agents, world_.wall.bonds, now.time);
  world_.divisions += report.divisions;
  if (report.divisions > 0 || agents.radius != radiusBefore) world_.changes.touch(Quantity::cellStates);
}

}  // namespace restenosis
