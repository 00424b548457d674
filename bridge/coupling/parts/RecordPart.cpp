#include "bridge/coupling/parts/RecordPart.h"

#include <algorithm>

#include "bridge/output/LumenWriter.h"
#include "bridge/output/TissueWriter.h"
#include "bridge/sampling/WssStatistics.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {

std::vector<PlannedPart> RecordPart::explain(const Scene&) { return {}; }

std::unique_ptr<RecordPart> RecordPart::make(const PartContext& context) {
  return std::make_unique<RecordPart>(context.world);
}

RecordPart::RecordPart(World& world)
    : world_(world),
      timeSeries_(world.folder.timeSeries()),
      tissue_(world.folder.path(), "tissue"),
      lumen_(world.folder.path(), "lumen") {}

std::vector<Quantity> RecordPart::reads() const {
  return {Quantity::cellStates, Quantity::agentPositions, Quantity::exposure,        Quantity::coverage,
          Quantity::lumen,      Quantity::wallTraction,   Quantity::wallShearStress, Quantity::nitricOxide};
}

Verdict RecordPart::needs(Quantity quantity, const Instant& now) const {
  // Where there is tissue, flow is a means to its growth, and what its rules need is what is recorded;
  // without, flow is what the scene is about.
  const bool flow = quantity == Quantity::wallTraction || quantity == Quantity::wallShearStress;
  if (flow && world_.scene.hasTissue())
    return Verdict::unless(world_.biology.rules().wssChangesNothingBecause(world_.wall.agents));
  return now.recorded ? Verdict::run() : Verdict::skip("nothing is recorded in this step");
}

void RecordPart::begin() {
  timeSeries_.begin();
  if (world_.scene.hasTissue()) tissue_.begin();
  lumen_.begin();
}

void RecordPart::run(const Instant& now) {
  auto measurement = world_.timer.measure("output");
  timeSeries_.append(row(now));
  const FlowSolution* flow = world_.flow.last ? &*world_.flow.last : nullptr;
  if (world_.scene.hasTissue()) {
    writeTissue(tissue_.dataFile(now.step), world_.wall.agents, now.time);
    tissue_.add(now.step, now.time);
  }
  if (!world_.lumen.closed) {
    const RadialMap* postDeployment = world_.scene.hasTissue() ? &world_.lumen.afterDeployment : nullptr;
    writeLumen(lumen_.dataFile(now.step), world_.lumenSurface(), flow, now.time, postDeployment);
    lumen_.add(now.step, now.time);
  }
  world_.flow.solvesRecorded = world_.flow.solves;
}

TimeSeriesRow RecordPart::row(const Instant& now) const {
  const AgentStore& agents = world_.wall.agents;
  const StateCounts counts = countStates(agents);
  TimeSeriesRow row;
  row.time = now.time;
  row.agents = agents.size();
  row.smc = counts.smc;
  row.iel = static_cast<std::uint64_t>(std::ranges::count(agents.kind, AgentKind::iel));
  row.eel = static_cast<std::uint64_t>(std::ranges::count(agents.kind, AgentKind::eel));
  row.divisions = world_.divisions;
  row.g0 = counts.g0, row.g1 = counts.g1, row.sg2m = counts.sg2m;
  row.synthetic = counts.synthetic, row.inhibited = counts.inhibited;
  row.covered = counts.covered, row.exposed = counts.exposed;
  if (world_.scene.endothelium) row.coverage = counts.coverage();
  double stress = 0, nitricOxide = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != AgentKind::smc) continue;
    stress += agents.pressure[i];
    if (agents.has(i, covered)) nitricOxide += agents.nitricOxide[i];
  }
  if (counts.smc > 0) row.stressMean = stress / counts.smc;
  if (counts.covered > 0) row.nitricOxideMean = nitricOxide / counts.covered;
  measureLumen(row);
  measureFlow(row);
  return row;
}

void RecordPart::measureLumen(TimeSeriesRow& row) const {
  if (world_.hasLoadedLumen()) return;
  const LumenState& lumen = world_.lumen;
  const auto [from, to] = world_.measuredSection();
  row.minLumenArea = lumen.present.minimalArea(from, to);
  if (!world_.scene.hasTissue()) return;
  const Neointima neointima = measureNeointima(lumen.afterDeployment, lumen.present, from, to);
  row.neointimaThickness = neointima.meanThickness;
  row.neointimaAreaFraction = neointima.meanAreaFraction;
  row.neointimaThicknessMax = *std::ranges::max_element(neointima.thickness);
  if (world_.flow.solves > 0) row.lumenMovement = displacement(lumen.atLastFlow, lumen.present).robust;
}

void RecordPart::measureFlow(TimeSeriesRow& row) const {
  row.flowSolves = world_.flow.solves;
  row.flowSolved = world_.flow.solves > world_.flow.solvesRecorded ? 1 : 0;
  if (!world_.flow.last) return;
  const double threshold =
      world_.biology.hasEndothelium() ? world_.biology.arrestingWss() : restenosis::lowWss;
  const WssStatistics wall = wssStatistics(world_.flow.last->wall, SurfaceRegion::wall, threshold);
  row.wssMean = wall.mean;
  row.wssLowAreaFraction = wall.lowAreaFraction;
  row.wssP5 = wall.p5, row.wssP50 = wall.median, row.wssP95 = wall.p95;
}

}  // namespace restenosis
