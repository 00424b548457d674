#include "bridge/coupling/parts/NitricOxidePart.h"

#include "bridge/coupling/FlowForecast.h"

namespace restenosis {

std::vector<PlannedPart> NitricOxidePart::explain(const Scene& scene) {
  const bool runs = scene.endothelium && scene.hasTissue() && noFlowBecause(scene).empty();
  return {{"nitric oxide", runs,
           runs ? "after the endothelium, from the last flow's wall shear stress" : "no wall shear stress"}};
}

std::unique_ptr<NitricOxidePart> NitricOxidePart::make(const PartContext& context) {
  RunState& run = context.run;
  if (!run.scene.endothelium) return nullptr;
  return std::make_unique<NitricOxidePart>(run.quantities, run.biology, run.timer);
}

Verdict NitricOxidePart::needs(Quantity quantity, const Instant&) const {
  if (quantity != Quantity::wallShearStress) return Verdict::run();
  return Verdict::unless(biology_.rules().wssChangesNothingBecause(*stress_));
}

void NitricOxidePart::run(const Instant&) {
  auto measurement = timer_.measure("biology");
  nitricOxide_.change([&](AgentStore& agents) { biology_.updateNitricOxide(agents); });
}

}  // namespace restenosis
