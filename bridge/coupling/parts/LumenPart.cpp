#include "bridge/coupling/parts/LumenPart.h"

#include "bridge/coupling/FlowForecast.h"
#include "bridge/surface/LumenSurface.h"

namespace restenosis {

std::vector<PlannedPart> LumenPart::explain(const Scene& scene) {
  return {{"lumen surface", true,
           noFlowBecause(scene).empty() ? "when the flow may be due, and at recorded steps"
                                        : "at recorded steps only"}};
}

std::unique_ptr<LumenPart> LumenPart::make(const PartContext& context) {
  return std::make_unique<LumenPart>(context.world);
}

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
