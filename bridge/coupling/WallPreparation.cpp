#include "bridge/coupling/WallPreparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "bridge/scene/LoadedWall.h"
#include "bridge/surface/SceneStent.h"
#include "tissue/forces/ForceField.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/InjuryRemark.h"
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

std::string explainDeployment(const Scene& scene) {
  if (!scene.stent) return "no [stent]";
  return fmt::format("{} steps to {:g} um, the wall relaxing after each", scene.stent->deploymentSteps,
                     scene.stent->deploymentDepth * 1e6);
}

}  // namespace

std::vector<PlannedPart> WallPreparation::explain(const Scene& scene) {
  return {{"wall", scene.hasTissue(), explainWall(scene)},
          {"deployment", scene.stent.has_value(), explainDeployment(scene)},
          {"injury", scene.injury.has_value(),
           scene.injury ? "once, after deployment" : "no [injury], so no cell becomes synthetic"}};
}

void WallPreparation::makeWall() {
  const VesselParameters& vessel = world_.scene.vessel;
  auto measurement = world_.timer.measure("pack");
  const std::string stage = vessel.agents.empty() ? "packing the wall" : "loading the wall";
  world_.progress.stage(stage, 0, 1);
  world_.wall = initialWall();
  world_.progress.stage(stage, 1, 1);
  if (!vessel.agents.empty()) world_.remark(remarkOnOpenEnds(vessel, world_.wall.agents));
}

Wall WallPreparation::initialWall() {
  const Scene& scene = world_.scene;
  const VesselParameters& vessel = scene.vessel;
  if (!vessel.agents.empty()) {
    std::optional<double> depth;
    if (scene.stent) depth = scene.stent->deploymentDepth;
    Wall wall = adoptWall(vessel, readWallTable(vessel, depth));
    // A packed wall's were set when it came to rest; injury may ask for them before this one does
    ForceField(*scene.mechanics).setPressures(wall.agents, wall.bonds);
    return wall;
  }
  return packWall(vessel, vessel.lumenSurface.empty() ? cylindricalShape(vessel) : loadedWallShape(vessel),
                  *scene.mechanics, *scene.relaxation, static_cast<std::uint64_t>(scene.scene.seed),
                  &world_.packing.emplace(), [this] {
                    if (options_.askedToStop()) throw Interrupted();
                  });
}

void WallPreparation::deploy(std::int32_t& stepsDone, const std::function<void()>& afterStep) {
  const Scene& scene = world_.scene;
  auto measurement = world_.timer.measure("deploy");
  Deployment deployment(world_.wall, makeStent(*scene.stent, scene.vessel), *scene.stent, scene.vessel,
                        *scene.mechanics, *scene.relaxation, stepsDone);
  while (!deployment.done()) {
    deployment.step();
    stepsDone = deployment.stepsDone();
    world_.progress.stage("deployment", stepsDone, deployment.steps());
    afterStep();
  }
  world_.wall.lastMove = std::vector<double>();
  world_.stent = deployment.stent();
  world_.deployment = deployment.statistics();
  world_.remark(remarkOnEscaped(*world_.deployment, deployment.steps()));
  requireWallOutsideStruts(*world_.deployment, deployment.steps());
  remarkOnContactLaw(world_, "after deployment");
}

void WallPreparation::injureAndConfine() {
  const Scene& scene = world_.scene;
  AgentStore& agents = world_.wall.agents;
  for (Index i = 0; i < agents.size(); ++i) {
    // The tissue outside is stiff: the EEL holds its place while cells grow (ISR3D).
    if (agents.kind[i] == AgentKind::eel) agents.set(i, fixed, true);
  }
  if (scene.injury) {
    world_.injury = injure(world_.wall, *scene.injury, static_cast<std::uint64_t>(scene.scene.seed));
    world_.remark(remarkOnInjury(*world_.injury, *scene.injury));
  }
  world_.confinement = OuterConfinement(agents, scene.vessel.cellRadius);
  world_.changes.touch(Quantity::cellStates);
}

void remarkOnContactLaw(World& world, const std::string& when) {
  constexpr std::string_view what =
      "agents are pressed deeper than the contact law holds for; its continuation acts on them";
  const auto tellsSo = [&](const std::string& text) { return text.find(what) != std::string::npos; };
  if (std::ranges::any_of(world.remarks, tellsSo)) return;
  const Index pressed = ForceField(*world.scene.mechanics).agentsBeyondLaw(world.wall.agents);
  if (pressed > 0) world.remark(fmt::format("{} {} of {} {}", when, pressed, world.wall.agents.size(), what));
}

}  // namespace restenosis
