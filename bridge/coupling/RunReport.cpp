#include "bridge/coupling/RunReport.h"

#include <vector>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/output/ProfileCsv.h"
#include "bridge/output/SummaryJson.h"
#include "bridge/output/ThicknessMapCsv.h"
#include "bridge/scene/SceneFingerprint.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {

RunReport::RunReport(World& world, const RunOptions& options)
    : world_(world), options_(options), sceneFingerprint_(sceneFingerprint(world.scene)) {}

void RunReport::progress(const Instant& now) const {
  const StateCounts counts = countStates(world_.wall.agents);
  ProgressState state;
  state.time = now.time;
  state.agents = world_.wall.agents.size();
  state.g0 = counts.g0, state.g1 = counts.g1, state.sg2m = counts.sg2m;
  state.divisions = world_.divisions;
  state.flowSolves = world_.flow.solves;
  world_.progress.step(state, now.recorded);
}

std::string RunReport::stateDigest() const {
  HashingArchive hash;
  hash(world_.wall.agents);
  return hash.digest();
}

std::optional<PoiseuilleError> RunReport::poiseuille() const {
  const Scene& scene = world_.scene;
  if (!world_.flow.last || !obeysPoiseuille(scene)) return std::nullopt;
  return poiseuilleError(world_.flow.last->wall, scene.vessel.lumenDiameter, scene.vessel.length,
                         scene.flow->conditions(scene.vessel.lumenDiameter));
}

void RunReport::writeFinalLumen() const {
  const RadialMap& present = world_.lumen.present;
  std::vector<ProfileRow> rows(static_cast<std::size_t>(present.planes()));
  std::optional<Neointima> neointima;
  if (world_.scene.hasTissue() && present.comparable(world_.lumen.afterDeployment))
    neointima = measureNeointima(world_.lumen.afterDeployment, present, 0.0, world_.wall.length);
  for (int k = 0; k < present.planes(); ++k) {
    rows[k].z = present.z(k);
    rows[k].lumenArea = present.lumenArea(k);
    if (!neointima) continue;
    rows[k].neointimaAreaFraction = neointima->areaFraction[k];
    rows[k].neointimaThickness = neointima->thickness[k];
  }
  writeProfileCsv(world_.folder.profile(), rows);
  if (neointima) writeThicknessMapCsv(world_.folder.thicknessMap(), world_.lumen.afterDeployment, present);
}

void RunReport::writeSummary(const std::string& status, const Schedule* schedule,
                             const RecordPart* record) const {
  const Scene& scene = world_.scene;
  Summary summary;
  summary.scene = scene.name;
  summary.title = scene.scene.title;
  summary.status = status;
  summary.seed = scene.scene.seed;
  summary.threads = options_.threads;
  summary.ranks = options_.ranks;
  if (scene.flow) summary.flowBackend = scene.flow->backend;
  // The state is of no one scene once the flow has had other settings on the way, or of no one program
  if (world_.reproducible && !world_.flow.mixed && world_.lastFlowHasTheseSettings())
    summary.sceneFingerprint = sceneFingerprint_;
  summary.stateDigest = stateDigest();
  if (record && !record->timeSeries().rows().empty()) summary.last = record->timeSeries().rows().back();
  summary.flowSolvesDone = world_.flow.solves;
  summary.flowMeshesMoved = world_.flow.meshesMoved;
  summary.flowRemeshed = world_.flow.remeshedBecause;
  if (schedule) {
    const auto flow = schedule->counts().find("flow");
    if (flow != schedule->counts().end()) summary.flowSolvesSkipped = flow->second.skipped;
  }
  summary.packing = world_.packing;
  summary.deployment = world_.deployment;
  summary.injury = world_.injury;
  summary.relaxationIterations = world_.relaxation.iterations;
  summary.agentEvaluations = world_.relaxation.agentEvaluations;
  summary.relaxationResidual = world_.relaxation.residual;
  summary.poiseuille = poiseuille();
  summary.parts = world_.timer.costs();
  summary.remarks = world_.remarks;
  writeSummaryJson(world_.folder.summary(), summary);
}

}  // namespace restenosis
