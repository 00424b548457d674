#include "bridge/coupling/CostForecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Instant.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/CellEstimate.h"
#include "bridge/output/DurationText.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/scene/SceneBiology.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenGrid.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/surface/StlFile.h"
#include "tissue/biology/Biology.h"
#include "tissue/parameters/SecondsPerDay.h"
#include "tissue/vessel/AgentCounts.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

/// Measured on two cores of a server; the order of magnitude is what matters.
struct CostEstimate {
  double programBytes = 5e7;
  double bytesPerAgent = 670;  ///< state, bonds, neighbour lists, output buffers
  double bytesPerNode = 7;     ///< of the distance field that the lumen is taken from, with all made of it
  double packSecondsPerAgent = 4e-5;
  double deploySecondsPerStep = 2e-6;  ///< per agent
  // Per agent: until growthEnd, where the surface grows or the bulk too, and after it
  double surfaceSecondsPerStep = 1.2e-6, bulkSecondsPerStep = 1.7e-6, restSecondsPerStep = 6e-7;
  // One solve by OpenFOAM, with its mesh, and by the lattice
  double foamBytes = 1.3e8, bytesPerCell = 4300, secondsPerCell = 3.5e-4, shareOfTwoRanks = 0.73;
  double secondsPerCellInAStep = 2.7e-6;  ///< of a beat, by one correction, on one core
  double latticeBytes = 3e7, bytesPerLatticeNode = 200, secondsPerLatticeNode = 1e-5;
};

/// About the grid that the lumen of the deployed wall is taken from.
LumenGrid lumenGrid(const Scene& scene) {
  const VesselParameters& vessel = scene.vessel;
  const double deployed = scene.stent ? scene.stent->deploymentDepth : 0;
  return {vessel.length, vessel.lumenDiameter / 2 + vessel.wallThickness + deployed,
          scene.coupling.surfaceResolution};
}

/// Obstacle agents that stand for the struts.
double strutAgents(const Scene& scene) {
  return scene.stent ? static_cast<double>(makeStent(*scene.stent, scene.vessel).spheres.size()) : 0;
}

/// Of struts pressed in, what is about in the lumen's view: their inner side and half of their flanks [m^2].
double strutArea(const Scene& scene) {
  if (!scene.stent || !scene.hasTissue()) return 0;
  double area = 0;
  for (const StrutSegment& segment : makeStent(*scene.stent, scene.vessel).segments)
    area += segment.length() * (segment.width + segment.thickness);
  return area;
}

/// The lumen as the scene gives it, with its straight ends.
LumenSize lumenSize(const Scene& scene) {
  using std::numbers::pi;
  const double ends = scene.flow->straightEnds;  // each of the two
  LumenSize size;
  if (scene.vessel.lumenSurface.empty()) {
    const double diameter = scene.vessel.lumenDiameter, length = scene.vessel.length + 2 * ends;
    size.wallArea = pi * diameter * length;
    size.volume = size.wallArea * diameter / 4;
    size.strutArea = strutArea(scene);
    return size;
  }
  const TriSurface lumen = loadLumen(scene.vessel, scene.outlets());
  size.volume = enclosedVolume(lumen);
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] == SurfaceRegion::wall) size.wallArea += lumen.areaVector(t).norm();
    if (lumen.region[t] == SurfaceRegion::strut) size.strutArea += lumen.areaVector(t).norm();
  }
  for (const SurfaceRegion end : allRegions(lumen)) {
    if (!isEnd(end)) continue;
    const double diameter = endDiameter(lumen, end);
    size.wallArea += pi * diameter * ends;
    size.volume += pi / 4 * diameter * diameter * ends;
  }
  return size;
}

/// Solves a day of growth, about: few and many with a tolerance of 20 um, and the powers of it that they go
/// with. Measured by the thesis's rules: 0.6 to 0.7 in a ring and 1 in the vessel; with 10 um 2.0 to 2.7 and
/// 7.3, with 5 um 5.2 in the ring. Where the bulk grows: 1.3 in a ring over 28 days, 2.1 over the first 10,
/// and 2.8 in the vessel.
struct SolvesADay {
  double few, many;
  double fewPower = -1.5, manyPower = -2.5, tolerance = 20e-6;
};
constexpr SolvesADay whereTheSurfaceGrows{0.6, 1.2}, whereTheBulkGrows{1.3, 3};
/// Growth goes on for some days after the endothelium is whole (assumed).
constexpr double lateGrowth = 5 * secondsPerDay;

/// About when the neointima stops growing [s]; the end of the run where nothing stops it.
double growthEnd(const Scene& scene) {
  if (!noFlowBecause(scene).empty()) return scene.scene.duration;
  return std::min(scene.scene.duration, Biology(biologySettings(scene)).endotheliumCompletion() + lateGrowth);
}

/// How often the flow is likely to be solved: once without tissue, at most as often as the lumen is looked
/// at.
void setSolves(FlowCost& flow, const Scene& scene) {
  if (!scene.hasTissue()) return;
  const double onset = Biology(biologySettings(scene)).endotheliumOnset();
  const bool always = scene.coupling.scheduleMode() == ScheduleMode::everyStep;
  std::uint32_t looks = 0;
  for (std::uint32_t step = 0; step <= stepCount(scene.scene); ++step) {
    const Instant now = instantOf(scene, step);
    if (always || (now.time >= onset && now.takesLumen)) ++looks;
  }
  looks = std::max(looks, 1U);
  const double days = std::max(0.0, growthEnd(scene) - onset) / secondsPerDay;
  const SolvesADay& rates = scene.activation ? whereTheBulkGrows : whereTheSurfaceGrows;
  const auto likely = [&](double aDay, double power) {
    if (always || scene.coupling.lumenTolerance == 0) return looks;
    const double number = days * aDay * std::pow(scene.coupling.lumenTolerance / rates.tolerance, power);
    return static_cast<std::uint32_t>(std::clamp(std::ceil(number), 1.0, 1.0 * looks));
  };
  flow.fewSolves = likely(rates.few, rates.fewPower);
  flow.manySolves = likely(rates.many, rates.manyPower);
}

/// "8 to 29", or one where both are the same.
std::string rangeText(const std::string& few, const std::string& many) {
  return few == many ? few : fmt::format("{} to {}", few, many);
}

/// Agents of the wall that is packed: as many as its shape is given.
double packedAgents(const Scene& scene) {
  const VesselParameters& vessel = scene.vessel;
  const WallShape shape = hasOwnLumen(vessel) ? loadedWallShape(vessel) : cylindricalShape(vessel);
  return countAgents(vessel, shape).total();
}

}  // namespace

int usualRanks(const Scene& scene) {
  return expectedCells(lumenSize(scene), scene.foamSettings()) > cellsWorthTwoRanks ? 2 : 1;
}

std::optional<FlowCost> flowCost(const Scene& scene) {
  if (!noFlowBecause(scene).empty()) return std::nullopt;
  const LumenSize lumen = lumenSize(scene);
  const CostEstimate cost;
  const auto of = [&](double pieces, std::string_view kind, double bytes, double seconds) {
    FlowCost flow{pieces, kind, bytes, seconds * pieces};
    setSolves(flow, scene);
    return flow;
  };
  if (scene.flow->backend == flowBackendNames::foam) {
    const FoamSettings foam = scene.foamSettings();
    const double cells = expectedCells(lumen, foam);
    double seconds = cost.secondsPerCell;
    if (scene.flow->isBeating())
      seconds += static_cast<double>(scene.flow->beats * foam.beatSteps * foam.beatCorrectors) *
                 cost.secondsPerCellInAStep;
    return of(cells, "cells", cost.foamBytes + cost.bytesPerCell * cells,
              seconds * (cells > cellsWorthTwoRanks ? cost.shareOfTwoRanks : 1));
  }
  if (scene.flow->backend == flowBackendNames::lbm) {
    const double nodes = lumen.volume / std::pow(scene.lbmSettings().dx, 3);
    return of(nodes, "lattice nodes", cost.latticeBytes + cost.bytesPerLatticeNode * nodes,
              cost.secondsPerLatticeNode);
  }
  return of(lumen.wallArea / std::pow(scene.coupling.surfaceResolution, 2), "places on the wall", 0, 0);
}

std::optional<TissueCost> tissueCost(const Scene& scene) {
  if (!scene.hasTissue()) return std::nullopt;
  const CostEstimate cost;
  TissueCost tissue;
  tissue.counted = !scene.vessel.agents.empty();
  const AgentStore wall = tissue.counted ? readAgentTable(scene.vessel.agents).agents : AgentStore();
  tissue.struts = strutAgents(scene);
  tissue.agents = (tissue.counted ? wall.size() : packedAgents(scene)) + tissue.struts;
  const double packing = tissue.counted ? 0 : cost.packSecondsPerAgent;
  const double deploySteps = scene.stent ? static_cast<double>(scene.stent->deploymentSteps) : 0;
  const double growing = growthEnd(scene), resting = scene.scene.duration - growing;
  const double growingSeconds = scene.activation ? cost.bulkSecondsPerStep : cost.surfaceSecondsPerStep;
  const double growth =
      scene.cellCycle ? (growing * growingSeconds + resting * cost.restSecondsPerStep) / scene.scene.step : 0;
  tissue.seconds = tissue.agents * (packing + deploySteps * cost.deploySecondsPerStep + growth);
  tissue.bytes = cost.programBytes + tissue.agents * cost.bytesPerAgent +
                 static_cast<double>(lumenGrid(scene).size()) * cost.bytesPerNode;
  tissue.openEnds = remarkOnOpenEnds(scene.vessel, wall);
  return tissue;
}

std::string costText(const Scene& scene) {
  const std::optional<FlowCost> flow = flowCost(scene);
  const std::optional<TissueCost> tissue = tissueCost(scene);
  if (!tissue && !flow) return "no agents, no flow\n";
  if (!tissue) {
    return fmt::format(
        "no agents; about {:.2g} {}, {:.0f} MB, {} on two cores for the one solve (rough estimates)\n",
        flow->pieces, flow->kind, flow->bytes / 1e6, durationText(flow->secondsASolve));
  }
  std::string text =
      fmt::format("{}{:.0f} agents{}, {:.0f} MB, {} on two cores without flow (rough estimates)\n",
                  tissue->counted ? "" : "about ", tissue->agents,
                  tissue->struts > 0 ? fmt::format(" ({:.0f} of them struts)", tissue->struts) : "",
                  tissue->bytes / 1e6, durationText(tissue->seconds));
  if (flow) {
    text += fmt::format("flow: about {:.2g} {}, {:.0f} MB, {} a solve; {} solves are likely: {}\n",
                        flow->pieces, flow->kind, flow->bytes / 1e6, durationText(flow->secondsASolve),
                        rangeText(std::to_string(flow->fewSolves), std::to_string(flow->manySolves)),
                        rangeText(durationText(flow->fewSolves * flow->secondsASolve),
                                  durationText(flow->manySolves * flow->secondsASolve)));
  }
  if (!tissue->openEnds.empty()) text += tissue->openEnds + "\n";
  return text;
}

}  // namespace restenosis
