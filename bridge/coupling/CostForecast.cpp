#include "bridge/coupling/CostForecast.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Instant.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/CellEstimate.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenGrid.h"
#include "bridge/surface/SceneStent.h"
#include "tissue/vessel/AgentCounts.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

/// Measured on two cores of a server; the order of magnitude is what matters.
struct CostEstimate {
  double programBytes = 4e7;
  double bytesPerAgent = 450;  ///< state, bonds, neighbour lists, output buffers
  double bytesPerNode = 7;     ///< of the distance field that the lumen is taken from, with all made of it
  double packSecondsPerAgent = 4e-5;
  double deploySecondsPerStep = 3e-6;  ///< per agent
  double growSecondsPerStep = 1.5e-6;  ///< per agent
  // One solve by OpenFOAM, with its mesh, and by the lattice
  double solverBytes = 6e7, bytesPerCell = 400, secondsPerCell = 2.7e-4;
  double bytesPerLatticeNode = 200, secondsPerLatticeNode = 1e-5;
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

/// Of the lumen of a scene without tissue, and its straight ends.
LumenSize lumenSize(const Scene& scene) {
  using std::numbers::pi;
  const double ends = scene.flow->straightEnds;  // each of the two
  LumenSize size;
  if (scene.vessel.lumenSurface.empty()) {
    const double diameter = scene.vessel.lumenDiameter, length = scene.vessel.length + 2 * ends;
    size.wallArea = pi * diameter * length;
    size.volume = size.wallArea * diameter / 4;
    return size;
  }
  const TriSurface lumen = loadLumen(scene.vessel);
  size.volume = enclosedVolume(lumen);
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] == SurfaceRegion::wall) size.wallArea += lumen.areaVector(t).norm();
    if (lumen.region[t] == SurfaceRegion::strut) size.strutArea += lumen.areaVector(t).norm();
  }
  for (const SurfaceRegion end : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
    const double diameter = endDiameter(lumen, end);
    size.wallArea += pi * diameter * ends;
    size.volume += pi / 4 * diameter * diameter * ends;
  }
  return size;
}

/// Agents of the wall that is packed: as many as its shape is given.
double packedAgents(const Scene& scene) {
  const VesselParameters& vessel = scene.vessel;
  const WallShape shape = vessel.lumenSurface.empty() ? cylindricalShape(vessel) : loadedWallShape(vessel);
  return countAgents(vessel, shape).total();
}

}  // namespace

std::string flowCostText(const Scene& scene) {
  if (scene.hasTissue()) return "";
  if (!noFlowBecause(scene).empty()) return "no agents, no flow\n";
  const LumenSize lumen = lumenSize(scene);
  const CostEstimate cost;
  const auto text = [&](double pieces, const char* name, double bytes, double seconds) {
    return fmt::format(
        "no agents; about {:.2g} {}, {:.0f} MB, {:.0f} s on two cores for the one solve (rough "
        "estimates)\n",
        pieces, name, (cost.solverBytes + bytes * pieces) / 1e6, seconds * pieces);
  };
  if (scene.flow->backend == flowBackendNames::foam)
    return text(expectedCells(lumen, scene.foamSettings()), "cells", cost.bytesPerCell, cost.secondsPerCell);
  if (scene.flow->backend == flowBackendNames::lbm)
    return text(lumen.volume / std::pow(scene.lbmSettings().dx, 3), "lattice nodes", cost.bytesPerLatticeNode,
                cost.secondsPerLatticeNode);
  return text(lumen.wallArea / std::pow(scene.coupling.surfaceResolution, 2), "places on the wall", 0, 0);
}

std::string tissueCostText(const Scene& scene) {
  if (!scene.hasTissue()) return "";
  const CostEstimate cost;
  const bool loaded = !scene.vessel.agents.empty();
  const AgentStore wall = loaded ? readAgentTable(scene.vessel.agents).agents : AgentStore();
  const double ofWall = loaded ? wall.size() : packedAgents(scene);
  const double agents = ofWall + strutAgents(scene);
  const double packing = loaded ? 0 : cost.packSecondsPerAgent;
  const double deploySteps = scene.stent ? static_cast<double>(scene.stent->deploymentSteps) : 0;
  const double seconds = agents * (packing + deploySteps * cost.deploySecondsPerStep +
                                   (scene.cellCycle ? stepCount(scene.scene) * cost.growSecondsPerStep : 0));
  const double bytes = cost.programBytes + agents * cost.bytesPerAgent +
                       static_cast<double>(lumenGrid(scene).size()) * cost.bytesPerNode;
  std::string text = fmt::format(
      "{}{:.0f} agents{}, {:.0f} MB, {:.0f} s on two cores without flow (rough estimates)\n",
      loaded ? "" : "about ", agents,
      agents > ofWall ? fmt::format(" ({:.0f} of them struts)", agents - ofWall) : "", bytes / 1e6, seconds);
  if (const std::string ends = remarkOnOpenEnds(scene.vessel, wall); !ends.empty()) text += ends + "\n";
  return text;
}

}  // namespace restenosis
