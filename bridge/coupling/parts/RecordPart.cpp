#include "bridge/coupling/parts/RecordPart.h"

#include <algorithm>
#include <utility>

#include "bridge/coupling/StentedSection.h"
#include "bridge/output/LumenWriter.h"
#include "bridge/output/StrutWriter.h"
#include "bridge/output/TissueWriter.h"
#include "bridge/sampling/WssStatistics.h"
#include "bridge/surface/Histology.h"
#include "bridge/surface/StrutSurface.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {

std::vector<PlannedPart> RecordPart::explain(const Scene&) { return {}; }

std::unique_ptr<RecordPart> RecordPart::make(const PartContext& context) {
  RunState& run = context.run;
  return std::make_unique<RecordPart>(run.quantities, run.scene, run.folder, run.biology, run.extraction,
                                      run.stent, run.divisions, run.crossCheck.checks, run.timer, run.axis);
}

RecordPart::RecordPart(Quantities& quantities, const Scene& scene, const ResultsFolder& folder,
                       const Biology& biology, LumenExtraction& extraction, const std::optional<Stent>& stent,
                       const std::uint64_t& divisions, const std::vector<CrossCheckRecord>& crossChecks,
                       PartTimer& timer, std::shared_ptr<const Centreline> axis)
    : Part(quantities),
      scene_(scene),
      biology_(biology),
      extraction_(extraction),
      stent_(stent),
      divisions_(divisions),
      crossChecks_(crossChecks),
      timer_(timer),
      axis_(std::move(axis)),
      timeSeries_(folder.timeSeries()),
      tissue_(folder.path(), "tissue"),
      lumenFiles_(folder.path(), "lumen"),
      strutsFile_(folder.path() / "struts.vtp") {
  // All that lives in the agents is written with them
  read<Quantity::agentPositions>();
  read<Quantity::exposure>();
  read<Quantity::coverage>();
  read<Quantity::wallShearStress>();
  read<Quantity::nitricOxide>();
}

Verdict RecordPart::needs(Quantity quantity, const Instant& now) const {
  // Where there is tissue, flow is a means to its growth, and what its rules need is what is recorded;
  // without, flow is what the scene is about.
  const bool flow = quantity == Quantity::wallTraction || quantity == Quantity::wallShearStress;
  if (flow && scene_.hasTissue())
    return Verdict::unless(biology_.rules().wssChangesNothingBecause(wall_->agents));
  return now.recorded ? Verdict::run() : Verdict::skip("nothing is recorded in this step");
}

void RecordPart::begin() {
  timeSeries_.begin();
  if (scene_.hasTissue()) tissue_.begin();
  lumenFiles_.begin();
  if (stent_) {
    auto measurement = timer_.measure("output");
    const TriSurface struts =
        strutSurface(stent_->segments, scene_.vessel.length, scene_.coupling.surfaceResolution);
    writeStruts(strutsFile_, axis_ ? bentAlong(*axis_, struts) : struts);
  }
}

void RecordPart::run(const Instant& now) {
  auto measurement = timer_.measure("output");
  timeSeries_.append(row(now));
  const FlowSolution* flow = flow_->last ? &*flow_->last : nullptr;
  if (scene_.hasTissue()) {
    writeTissue(tissue_.dataFile(now.step), wall_->agents, now.time, axis_.get());
    tissue_.add(now.step, now.time);
  }
  if (!lumen_->closed) {
    const RadialMap* postDeployment = scene_.hasTissue() ? &lumen_->afterDeployment : nullptr;
    writeLumen(lumenFiles_.dataFile(now.step), extraction_.surface(), flow, now.time, postDeployment,
               axis_.get());
    lumenFiles_.add(now.step, now.time);
  }
  solvesRecorded_ = flow_->solves;
  crossChecksRecorded_ = crossChecks_.size();
}

TimeSeriesRow RecordPart::row(const Instant& now) const {
  const AgentStore& agents = wall_->agents;
  const StateCounts counts = countStates(agents);
  TimeSeriesRow row;
  row.time = now.time;
  row.agents = agents.size();
  row.smc = counts.smc;
  row.iel = static_cast<std::uint64_t>(std::ranges::count(agents.kind, AgentKind::iel));
  row.eel = static_cast<std::uint64_t>(std::ranges::count(agents.kind, AgentKind::eel));
  row.divisions = divisions_;
  row.g0 = counts.g0, row.g1 = counts.g1, row.sg2m = counts.sg2m;
  row.synthetic = counts.synthetic, row.inhibited = counts.inhibited;
  row.covered = counts.covered, row.exposed = counts.exposed;
  if (scene_.endothelium) row.coverage = counts.coverage();
  double stress = 0, nitricOxide = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != AgentKind::smc) continue;
    stress += agents.stress[i];
    if (agents.has(i, covered)) nitricOxide += agents.nitricOxide[i];
  }
  if (counts.smc > 0) row.stressMean = stress / counts.smc;
  if (counts.covered > 0) row.nitricOxideMean = nitricOxide / counts.covered;
  measureLumen(row);
  measureFlow(row);
  fillCrossCheck(row);
  return row;
}

void RecordPart::measureLumen(TimeSeriesRow& row) const {
  if (scene_.hasLoadedLumen()) return;
  const LumenState& lumen = *lumen_;
  const auto [from, to] = stentedSection(stent_, wall_->length);
  row.minLumenArea = lumen.present.minimalArea(from, to);
  if (!scene_.hasTissue()) return;
  const Neointima neointima = measureNeointima(lumen.afterDeployment, lumen.present, from, to);
  row.neointimaThickness = neointima.meanThickness;
  row.neointimaAreaFraction = neointima.meanAreaFraction;
  row.neointimaThicknessMax = *std::ranges::max_element(neointima.thickness);
  if (const Histology histology(wall_->agents, wall_->cellRadius);
      histology.possible() && !lumen.insideIelAfterDeployment.empty()) {
    const auto sections = histology.sections(lumen.present, lumen.insideIelAfterDeployment);
    const Section cut = histologySection(stent_, wall_->length);
    const HistologySection mean = Histology::mean(lumen.present, sections, cut.from, cut.to);
    row.intimaArea = mean.intimaArea, row.mediaArea = mean.mediaArea;
    row.relativeIntimaArea = mean.relativeIntimaArea;
    row.intimaCells = mean.intimaCells, row.intimaInCycle = mean.inCycle();
    if (wall_->agents.matrix.modelled()) row.intimaMatrixShare = mean.matrixShare();
  }
  if (flow_->solves > 0) row.lumenMovement = displacement(flow_->lumen, lumen.present).robust;
}

void RecordPart::measureFlow(TimeSeriesRow& row) const {
  row.flowSolves = flow_->solves;
  row.flowSolved = flow_->solves > solvesRecorded_ ? 1 : 0;
  if (!flow_->last) return;
  const double threshold = biology_.hasEndothelium() ? biology_.arrestingWss() : restenosis::lowWss;
  const WssStatistics wall = wssStatistics(flow_->last->wall, SurfaceRegion::wall, threshold);
  row.wssMean = wall.mean;
  row.wssLowAreaFraction = wall.lowAreaFraction;
  row.flowRate = flow_->last->flowRate, row.pressureDrop = flow_->last->pressureDrop;
  row.wssP5 = wall.p5, row.wssP50 = wall.median, row.wssP95 = wall.p95;
}

void RecordPart::fillCrossCheck(TimeSeriesRow& row) const {
  if (crossChecks_.size() == crossChecksRecorded_) return;
  const CrossCheckRecord& last = crossChecks_.back();
  const auto fill = [](const std::optional<StressDifference>& difference, auto& mean, auto& l2) {
    if (difference) mean = difference->mean, l2 = difference->l2;
  };
  fill(last.smoothWall, row.crossCheckSmoothMean, row.crossCheckSmoothL2);
  fill(last.nearStruts, row.crossCheckNearStrutsMean, row.crossCheckNearStrutsL2);
  fill(last.struts, row.crossCheckStrutsMean, row.crossCheckStrutsL2);
  row.crossCheckDecidedOtherwise = last.decidedOtherwise;
}

}  // namespace restenosis
