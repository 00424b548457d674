#include "bridge/coupling/parts/EndotheliumPart.h"

#include <fmt/format.h>

#include <cmath>

#include "bridge/scene/SceneBiology.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

std::vector<PlannedPart> EndotheliumPart::explain(const Scene& scene) {
  const auto say = [](bool runs, const std::string& text) {
    return std::vector<PlannedPart>{{"endothelium", runs, text}};
  };
  if (!scene.endothelium) return say(false, "no [endothelium], so no nitric oxide");
  if (!scene.cellCycle) return say(false, "no [cellCycle]");
  const std::string& scenario = scene.endothelium->scenario;
  const double onset = Biology(biologySettings(scene)).endotheliumOnset();
  if (std::isinf(onset)) return say(false, fmt::format("\"{}\": it never returns", scenario));
  return say(true, fmt::format("\"{}\", in every step from day {:g}", scenario, onset / secondsPerDay));
}

std::unique_ptr<EndotheliumPart> EndotheliumPart::make(const PartContext& context) {
  RunState& run = context.run;
  if (!run.scene.endothelium) return nullptr;
  return std::make_unique<EndotheliumPart>(run.quantities, run.biology, run.timer);
}

Verdict EndotheliumPart::inputsChanged(const Instant& now) const {
  if (now.time >= biology_.endotheliumOnset()) return Verdict::run();
  return Verdict::skip("endothelium has not begun to return");
}

void EndotheliumPart::run(const Instant& now) {
  auto measurement = timer_.measure("biology");
  coverage_.change([&](AgentStore& agents) { biology_.updateEndothelium(agents, now.time); });
}

}  // namespace restenosis
