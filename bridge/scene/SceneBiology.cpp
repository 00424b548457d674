#include "bridge/scene/SceneBiology.h"

#include "bridge/flow/FlowBackendNames.h"
#include "tissue/biology/ArrestRules.h"

namespace restenosis {

BiologySettings biologySettings(const Scene& scene) {
  BiologySettings settings;
  settings.cellCycle = scene.cellCycle;
  settings.activation = scene.activation;
  settings.extracellularMatrix = scene.extracellularMatrix;
  settings.contactInhibition = scene.contactInhibition;
  settings.endothelium = scene.endothelium;
  settings.denuded = !scene.injury || scene.injury->denuded();
  settings.seed = static_cast<std::uint64_t>(scene.scene.seed);
  settings.step = scene.scene.step;
  settings.vesselLength = scene.vessel.length;
  return settings;
}

bool growthReadsFlow(const Scene& scene) {
  const bool flows = scene.flow && scene.flow->backend != flowBackendNames::none;
  return flows && scene.hasTissue() && ArrestRules(biologySettings(scene)).readWss();
}

}  // namespace restenosis
