#include "bridge/coupling/RunReport.h"

#include <algorithm>
#include <vector>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Plan.h"
#include "bridge/coupling/parts/CrossCheckPart.h"
#include "bridge/output/ProfileCsv.h"
#include "bridge/output/SummaryJson.h"
#include "bridge/output/ThicknessMapCsv.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/Units.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {

RunReport::RunReport(RunState& state, const RunOptions& options)
    : state_(state),
      quantities_(state.quantities),
      options_(options),
      sceneFingerprint_(sceneFingerprint(state.scene)),
      plan_(plannedParts(state.scene)) {}

void RunReport::progress(const Instant& now) const {
  const StateCounts counts = countStates(quantities_.wall.agents);
  ProgressState progress;
  progress.time = now.time;
  progress.agents = quantities_.wall.agents.size();
  progress.g0 = counts.g0, progress.g1 = counts.g1, progress.sg2m = counts.sg2m;
  progress.divisions = state_.divisions;
  progress.flowSolves = quantities_.flow.solves;
  progress.flowToCome = noFlowBecause(state_.scene).empty() && quantities_.flow.solves == 0;
  state_.progress.step(progress, now.recorded);
}

std::string RunReport::stateDigest() const {
  HashingArchive hash;
  hash(quantities_.wall.agents);
  return hash.digest();
}

std::optional<PoiseuilleError> RunReport::poiseuille() const {
  const Scene& scene = state_.scene;
  if (!quantities_.flow.last || !obeysPoiseuille(scene)) return std::nullopt;
  return poiseuilleError(quantities_.flow.last->wall, scene.vessel.lumenDiameter, scene.vessel.length,
                         scene.flow->conditions(scene.vessel.lumenDiameter));
}

void RunReport::writeFinalLumen() const {
  const RadialMap& present = quantities_.lumen.present;
  std::vector<ProfileRow> rows(static_cast<std::size_t>(present.planes()));
  std::optional<Neointima> neointima;
  if (state_.scene.hasTissue() && present.comparable(quantities_.lumen.afterDeployment))
    neointima = measureNeointima(quantities_.lumen.afterDeployment, present, 0.0, quantities_.wall.length);
  std::vector<HistologySection> sections;
  const AgentStore& agents = quantities_.wall.agents;
  if (const std::vector<double>& before = quantities_.lumen.insideIelAfterDeployment; !before.empty())
    if (const Histology histology(agents, quantities_.wall.cellRadius); histology.possible())
      sections = histology.sections(present, before);
  for (int k = 0; k < present.planes(); ++k) {
    rows[k].z = present.z(k);
    rows[k].matrix = agents.matrix.modelled();
    if (!sections.empty()) rows[k].histology = sections[k];
    rows[k].lumenArea = present.lumenArea(k);
    if (!neointima) continue;
    rows[k].neointimaAreaFraction = neointima->areaFraction[k];
    rows[k].neointimaThickness = neointima->thickness[k];
  }
  writeProfileCsv(state_.folder.profile(), rows);
  if (neointima)
    writeThicknessMapCsv(state_.folder.thicknessMap(), quantities_.lumen.afterDeployment, present);
}

void RunReport::writeSummary(const std::string& status, const Schedule* schedule,
                             const RecordPart* record) const {
  const Scene& scene = state_.scene;
  Summary summary;
  summary.scene = scene.name;
  summary.title = scene.scene.title;
  summary.status = status;
  summary.seed = scene.scene.seed;
  summary.threads = options_.threads;
  summary.ranks = options_.ranks;
  if (scene.flow) summary.flowBackend = scene.flow->backend;
  // The state is of no one scene once the flow has had other settings on the way, or of no one program
  if (state_.reproducible && !quantities_.flow.mixed && state_.lastFlowHasTheseSettings())
    summary.sceneFingerprint = sceneFingerprint_;
  summary.stateDigest = stateDigest();
  if (record && !record->timeSeries().rows().empty()) summary.last = record->timeSeries().rows().back();
  summary.flowSolvesDone = quantities_.flow.solves;
  summary.flowMeshesMoved = quantities_.flow.meshesMoved;
  summary.flowRemeshed = quantities_.flow.remeshedBecause;
  if (const auto& flow = quantities_.flow.last; flow && flow->beats.beats > 0) summary.beats = flow->beats;
  if (const auto& flow = quantities_.flow.last; flow && !flow->outlets.empty()) {
    const auto names = scene.flow->outletsOfTable();
    for (std::size_t n = 0; n < std::min(names.size(), flow->outlets.size()); ++n)
      summary.outlets.emplace_back(names[n].name, flow->outlets[n]);
  }
  if (schedule) {
    const auto flow = schedule->counts().find("flow");
    if (flow != schedule->counts().end()) summary.flowSolvesSkipped = flow->second.skipped;
  }
  if (scene.flow && scene.flow->isCrossChecked()) summary.crossCheck = crossCheckSummary(state_);
  summary.packing = state_.packing;
  summary.deployment = state_.deployment;
  summary.injury = state_.injury;
  summary.relaxationIterations = state_.relaxation.iterations;
  summary.agentEvaluations = state_.relaxation.agentEvaluations;
  summary.relaxationResidual = state_.relaxation.residual;
  summary.poiseuille = poiseuille();
  summary.parts = state_.timer.costs();
  summary.remarks = state_.remarks;
  summary.plan = plan_;
  summary.differences = defaultDifferences(scene, Units());
  summary.provenance = provenance_;
  writeSummaryJson(state_.folder.summary(), summary);
}

}  // namespace restenosis
