#include "bridge/coupling/FlowForecast.h"

#include <fmt/format.h>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/foam/FoamRequirements.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/scene/FlowResolution.h"
#include "bridge/scene/SceneBiology.h"
#include "bridge/scene/Units.h"

namespace restenosis {
namespace {

// Beyond this Reynolds number the flow in a pipe is known to become turbulent (Reynolds 1883: 2000 to 2300).
constexpr double largestLaminar = 2000;

}  // namespace

std::string noFlowBecause(const Scene& scene) {
  return noFlowBecause(scene, ArrestRules(biologySettings(scene)));
}

std::string noFlowBecause(const Scene& scene, const ArrestRules& rules) {
  if (!scene.flow) return "no [flow]";
  if (scene.flow->backend == flowBackendNames::none) return "flow.backend is \"none\"";
  if (!scene.hasTissue()) return "";
  if (!rules.readWss()) return "no [endothelium], so no rule reads wall shear stress";
  if (!scene.cellCycle) return "no [cellCycle], so nothing can be put to rest";
  return rules.readNoWssUntil(scene.scene.duration);
}

bool obeysPoiseuille(const Scene& scene) {
  return !scene.hasTissue() && scene.vessel.stenosis == 0 && scene.vessel.lumenSurface.empty() &&
         !scene.vessel.isBent() && !scene.flow->isBeating() &&
         scene.flow->keeps() == FlowConditions::Drive::flowRate &&
         !scene.flow->distal(scene.vessel.lumenDiameter);
}

std::string turbulenceForecast(const Scene& scene) {
  if (!noFlowBecause(scene).empty()) return "";
  const double number = scene.flow->reynoldsNumber(scene.vessel.lumenDiameter);
  if (number <= largestLaminar) return "";
  return fmt::format(
      "has the Reynolds number {:.4g}: beyond some {:g} the flow in a tube is turbulent, and it is computed "
      "as a steady laminar one; are velocity, viscosity and diameter right?",
      number, largestLaminar);
}

std::vector<std::string> flowForecast(const Scene& scene, int ranks) {
  std::vector<std::string> known;
  if (!noFlowBecause(scene).empty()) return known;
  if (const auto problem = resolutionProblem(scene, Units()))
    known.push_back(fmt::format("will be refused: {}", problem->message));
  if (scene.flow->backend == flowBackendNames::foam) {
    if (const std::string missing = missingFoamProgram(ranks); !missing.empty())
      known.push_back(fmt::format("will fail: {}", missing));
    if (const std::string missing = missingFoamTemplate(); !missing.empty())
      known.push_back(fmt::format("will fail: {}", missing));
  }
  if (std::string turbulent = turbulenceForecast(scene); !turbulent.empty())
    known.push_back(std::move(turbulent));
  return known;
}

}  // namespace restenosis
