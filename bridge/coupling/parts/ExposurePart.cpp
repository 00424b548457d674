#include "bridge/coupling/parts/ExposurePart.h"

namespace restenosis {

std::vector<PlannedPart> ExposurePart::explain(const Scene& scene) {
  const auto say = [](bool runs, const char* text) {
    return std::vector<PlannedPart>{{"contact inhibition", runs, text}};
  };
  if (!scene.cellCycle) return say(false, "no [cellCycle]");
  if (!scene.contactInhibition) return say(false, "no [contactInhibition]: no cell is inhibited");
  return say(true, "in every step in which an agent moved");
}

std::unique_ptr<ExposurePart> ExposurePart::make(const PartContext& context) {
  if (!context.world.scene.cellCycle) return nullptr;
  return std::make_unique<ExposurePart>(context.world);
}

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
