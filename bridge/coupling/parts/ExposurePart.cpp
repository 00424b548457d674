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
  RunState& run = context.run;
  if (!run.scene.cellCycle) return nullptr;
  return std::make_unique<ExposurePart>(run.quantities, run.biology, run.timer);
}

Verdict ExposurePart::inputsChanged(const Instant&) const {
  return hasNewInput() ? Verdict::run() : Verdict::skip("no agent moved");
}

void ExposurePart::run(const Instant&) {
  auto measurement = timer_.measure("biology");
  exposure_.change([&](AgentStore& agents) { biology_.updateInhibition(agents); });
}

}  // namespace restenosis
