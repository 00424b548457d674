#include "bridge/coupling/parts/NitricOxidePart.h"

#include "bridge/coupling/FlowForecast.h"

namespace restenosis {

std::vector<PlannedPart> NitricOxidePart::explain(const Scene& scene) {
  const bool runs = scene.endothelium && scene.hasTissue() && noFlowBecause(scene).empty();
  return {{"nitric oxide", runs,
           runs ? "after the endothelium, from the last flow's wall shear stress" : "no wall shear stress"}};
}

std::unique_ptr<NitricOxidePart> NitricOxidePart::make(const PartContext& context) {
  if (!context.world.scene.endothelium) return nullptr;
  return std::make_unique<NitricOxidePart>(context.world);
}

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
