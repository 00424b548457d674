#include "bridge/coupling/WallPreparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "bridge/scene/LoadedWall.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/surface/VesselAxis.h"
#include "tissue/forces/ForceField.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/InjuryRemark.h"
#include "tissue/stent/TissueStrain.h"
#include "tissue/vessel/WallPacking.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

std::string explainWall(const Scene& scene) {
  const VesselParameters& vessel = scene.vessel;
  if (scene.hasLoadedLumen()) return "no [mechanics], so no tissue: the lumen is " + vessel.lumenSurface;
  if (!scene.hasTissue()) return "no [mechanics], so no tissue: the lumen is the vessel's own shape";
  if (!vessel.lumenSurface.empty())
    return fmt::format("packed once around {}, then relaxed", vessel.lumenSurface);
  if (!vessel.agents.empty()) return "loaded as it stands from " + vessel.agents;
  return "packed once, then relaxed";
}

std::string explainBend(const Scene& scene) {
  const VesselParameters& vessel = scene.vessel;
  const double sharpest = sharpestRadius(vessel);
  std::string text =
      vessel.curvatureRadius > 0
          ? fmt::format("the axis lies on an arc of {:g} mm", 1e3 * sharpest)
          : fmt::format("the axis is {}, {:.4g} mm long, its radius of curvature {:.3g} mm or more{}",
                        vessel.lumenSurfaceIsBent ? "that of sections of the surface"
                                                  : "that of " + vessel.centreline,
                        1e3 * vessel.length, 1e3 * sharpest,
                        hasRadiiAlong(vessel) ? ", with radii of its own" : "");
  if (scene.hasTissue())
    text +=
        fmt::format("; tissue grows as about a straight one: distances along the outer wall are {:.2g} % off",
                    100 * (vessel.lumenDiameter / 2 + vessel.wallThickness) / sharpest);
  return text;
}

std::string explainDeployment(const Scene& scene) {
  if (!scene.stent) return "no [stent]";
  return fmt::format("{} steps to {:g} um, the wall relaxing after each", scene.stent->deploymentSteps,
                     scene.stent->deploymentDepth * 1e6);
}

}  // namespace

std::vector<PlannedPart> WallPreparation::explain(const Scene& scene) {
  std::vector<PlannedPart> parts{
      {"wall", scene.hasTissue(), explainWall(scene)},
      {"deployment", scene.stent.has_value(), explainDeployment(scene)},
      {"injury", scene.injury.has_value(),
       scene.injury ? "once, after deployment" : "no [injury], so no cell becomes synthetic"}};
  if (scene.vessel.isBent()) parts.insert(parts.begin(), {"bend", true, explainBend(scene)});
  return parts;
}

void WallPreparation::makeWall() {
  const VesselParameters& vessel = state_.scene.vessel;
  auto measurement = state_.timer.measure("pack");
  const std::string stage = vessel.agents.empty() ? "packing the wall" : "loading the wall";
  state_.progress.stage(stage, 0, 1);
  wall_ = initialWall();
  state_.biology.model(wall_.agents);
  state_.progress.stage(stage, 1, 1);
  if (!vessel.agents.empty()) state_.remark(remarkOnOpenEnds(vessel, wall_.agents));
}

Wall WallPreparation::initialWall() {
  const Scene& scene = state_.scene;
  const VesselParameters& vessel = scene.vessel;
  if (!vessel.agents.empty()) {
    std::optional<double> depth;
    if (scene.stent) depth = scene.stent->deploymentDepth;
    Wall wall = adoptWall(vessel, readWallTable(vessel, depth));
    // A packed wall's were set when it came to rest; injury may ask for them before this one does
    ForceField(*scene.mechanics).setStresses(wall.agents, wall.bonds);
    return wall;
  }
  return packWall(vessel, hasOwnLumen(vessel) ? loadedWallShape(vessel) : cylindricalShape(vessel),
                  *scene.mechanics, *scene.relaxation, static_cast<std::uint64_t>(scene.scene.seed),
                  &state_.packing.emplace(), [this] {
                    if (options_.askedToStop()) throw Interrupted();
                  });
}

void WallPreparation::deploy(std::int32_t& stepsDone, const std::function<void()>& afterStep) {
  const Scene& scene = state_.scene;
  auto measurement = state_.timer.measure("deploy");
  if (state_.biology.hasActivation() && wall_.packedPlaces.empty()) notePackedPlaces();
  Deployment deployment(wall_, makeStent(*scene.stent, scene.vessel), *scene.stent, scene.vessel,
                        *scene.mechanics, *scene.relaxation, stepsDone);
  while (!deployment.done()) {
    deployment.step();
    stepsDone = deployment.stepsDone();
    state_.progress.stage("deployment", stepsDone, deployment.steps());
    afterStep();
  }
  wall_.lastMove = std::vector<double>();
  state_.stent = deployment.stent();
  state_.deployment = deployment.statistics();
  state_.remark(remarkOnEscaped(*state_.deployment, deployment.steps()));
  requireWallOutsideStruts(*state_.deployment, deployment.steps());
  remarkOnContactLaw(state_, "after deployment");
}

void WallPreparation::notePackedPlaces() {
  const AgentStore& agents = wall_.agents;
  wall_.packedPlaces.reserve(3 * std::size_t{agents.size()});
  for (Index i = 0; i < agents.size(); ++i)
    wall_.packedPlaces.insert(wall_.packedPlaces.end(), {agents.x[i], agents.y[i], agents.z[i]});
}

void WallPreparation::injureAndConfine() {
  const Scene& scene = state_.scene;
  AgentStore& agents = wall_.agents;
  for (Index i = 0; i < agents.size(); ++i) {
    // The tissue outside is stiff: the EEL holds its place while cells grow (ISR3D).
    if (agents.kind[i] == AgentKind::eel) agents.set(i, fixed, true);
  }
  if (!wall_.packedPlaces.empty())
    state_.biology.stretch(agents, strainAroundVessel(agents, wall_.packedPlaces));
  wall_.packedPlaces = std::vector<double>();
  if (scene.injury) {
    state_.injury = injure(wall_, *scene.injury, static_cast<std::uint64_t>(scene.scene.seed));
    state_.remark(remarkOnInjury(*state_.injury, *scene.injury));
  }
  const Index byStretch = state_.biology.begin(agents);
  if (state_.injury) {
    state_.injury->syntheticByStretch = byStretch;
    state_.injury->synthetic += byStretch;
  }
  state_.confinement = OuterConfinement(agents, scene.vessel.cellRadius);
  state_.quantities.countChange(Quantity::cellStates);
}

void remarkOnContactLaw(RunState& state, const std::string& when) {
  constexpr std::string_view what =
      "agents are pressed deeper than the contact law holds for; its continuation acts on them";
  const auto tellsSo = [&](const std::string& text) { return text.find(what) != std::string::npos; };
  if (std::ranges::any_of(state.remarks, tellsSo)) return;
  const Index pressed = ForceField(*state.scene.mechanics).agentsBeyondLaw(state.quantities.wall.agents);
  if (pressed > 0)
    state.remark(fmt::format("{} {} of {} {}", when, pressed, state.quantities.wall.agents.size(), what));
}

}  // namespace restenosis
