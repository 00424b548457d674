#include <fmt/format.h>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/WomersleyFlow.h"
#include "bridge/scene/SceneBiology.h"

namespace restenosis {
namespace {

constexpr double mmHg = 133.322387415;  ///< [Pa]

/// Only of a packed wall: a loaded one may have gaps in its IEL, or none at all.
bool nothingCanBeExposed(const Scene& scene) {
  if (!scene.vessel.agents.empty()) return false;
  return !scene.injury || scene.injury->sparesIel(scene.stent.has_value());
}

std::string whenFlowIsSolved(const Scene& scene) {
  if (!scene.hasTissue()) return "once: without tissue the lumen does not change";
  if (scene.coupling.scheduleMode() == ScheduleMode::everyStep)
    return fmt::format("in every one of the {} steps (coupling.schedule = \"everyStep\")",
                       stepCount(scene.scene) + 1);
  std::string text = fmt::format(
      "{} and the lumen has moved more than {:g} um over 1 % of it, or at {:g} % of the cells near the "
      "stress that arrests them",
      ArrestRules(biologySettings(scene)).whenWssIsRead(), scene.coupling.lumenTolerance * 1e6,
      scene.coupling.undecidedShare * 100);
  if (scene.coupling.lumenInterval > scene.scene.step)
    text += fmt::format("; the lumen is looked at every {:g} h", scene.coupling.lumenInterval / 3600);
  if (scene.endothelium && nothingCanBeExposed(scene))
    text +=
        "; the IEL is intact, so no cell is exposed, none is covered, and the flow is expected never to be "
        "due";
  return text;
}

std::vector<PlannedPart> meshExplanation(const Scene& scene) {
  // No mesh in a bend is moved
  const bool afresh = !scene.coupling.movesMesh() || scene.vessel.isBent();
  if (scene.flow->backend == flowBackendNames::foam && scene.hasTissue())
    return {{"mesh", true,
             afresh ? "a new one for every solve"
                    : "moved with the wall, and a new one where that is not good enough"}};
  if (scene.flow->backend == flowBackendNames::lbm && !afresh)
    return {{"mesh", false, "coupling.remesh is about OpenFOAM's mesh: every solve makes a new lattice"}};
  return {};
}

}  // namespace

std::vector<PlannedPart> FlowPart::explain(const Scene& scene) {
  if (const std::string noFlow = noFlowBecause(scene); !noFlow.empty()) return {{"flow", false, noFlow}};
  std::string text = whenFlowIsSolved(scene);
  for (const std::string& known : flowForecast(scene, 1)) text += "; it " + known;
  std::vector<PlannedPart> parts{{fmt::format("flow ({})", scene.flow->backend), true, text}};
  for (PlannedPart& mesh : meshExplanation(scene)) parts.push_back(std::move(mesh));
  if (const auto law = scene.flow->thinning())
    parts.push_back(
        {"viscosity", true,
         fmt::format("blood thins ({}): {:.3g} mPa s at the wall of the undeformed lumen",
                     scene.flow->viscosity,
                     1e3 * scene.flow->density * scene.flow->wallViscosity(scene.vessel.lumenDiameter))});
  if (const auto beating = scene.flow->beating())
    parts.push_back(
        {"beats", true,
         fmt::format("after each steady flow {} beats of {:.3g} s, Womersley number {:.2g}; cells feel {}",
                     beating->beats, beating->waveform.period,
                     WomersleyFlow(beating->waveform, scene.vessel.lumenDiameter / 2,
                                   scene.flow->wallViscosity(scene.vessel.lumenDiameter))
                         .womersleyNumber(),
                     beating->meanStress ? "the mean stress of the last" : "the steady flow's stress")});
  for (const Outlet& outlet : scene.flow->outletsOfTable())
    parts.push_back({"outlet", true,
                     outlet.resistance > 0
                         ? fmt::format("{}: what {:.3g} mmHg min/ml behind it let through", outlet.name,
                                       outlet.resistance / (60e6 * mmHg))
                         : fmt::format("{}: {:.3g} % of the flow", outlet.name, 100 * outlet.share)});
  if (const auto distal = scene.flow->distal(scene.vessel.lumenDiameter))
    parts.push_back(
        {"distal resistance", true,
         fmt::format("{:.4g} mmHg along the lumen and {:.3g} mmHg min/ml behind it: {:.4g} ml/min "
                     "through a lumen that does not resist",
                     distal->pressure / mmHg, distal->resistance / (60e6 * mmHg),
                     60e6 * distal->pressure / distal->resistance)});
  if (scene.flow->straightEnds > 0)
    parts.push_back(
        {"straight ends", true,
         fmt::format("{:g} mm of {} before the inlet and behind the outlet, in the flow only",
                     scene.flow->straightEnds * 1e3, scene.vessel.isBent() ? "the bend" : "straight tube")});
  return parts;
}

}  // namespace restenosis
