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
  return std::make_unique<LumenPart>(context.run.quantities, context.run.extraction);
}

Verdict LumenPart::inputsChanged(const Instant& now) const {
  // The first solve is of the lumen of its step
  if (!now.takesLumen && flow_->solves > 0) return Verdict::skip("lumenInterval is not over");
  if (hasNewInput() || lumen_->closed) return Verdict::run();
  return Verdict::skip("no agent moved");
}

void LumenPart::run(const Instant& now) {
  lumen_.change([&](LumenState& lumen) { extraction_.extract(lumen); });
  if (lumen_->closed && looksForOcclusion(now)) throw Occluded();
}

}  // namespace restenosis
