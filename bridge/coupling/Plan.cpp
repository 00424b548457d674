#include "bridge/coupling/Plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Run.h"
#include "bridge/coupling/World.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/CellEstimate.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/scene/Units.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenGrid.h"
#include "bridge/surface/SceneStent.h"
#include "tissue/biology/Biology.h"
#include "tissue/parameters/Printable.h"
#include "tissue/parameters/SecondsPerDay.h"
#include "tissue/vessel/AgentCounts.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

constexpr double day = secondsPerDay;

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

/// Only of a packed wall: a loaded one may have gaps in its IEL, or none at all.
bool nothingCanBeExposed(const Scene& scene) {
  if (!scene.vessel.agents.empty()) return false;
  if (!scene.injury) return true;
  const InjuryParameters& injury = *scene.injury;
  // Limits that the IEL is past as it is packed
  const bool anyStrain =
      injury.stretchedStrain == 0 ||
      (injury.ielBreaks && std::min(injury.strainLimitAround, injury.strainLimitAlong) == 0);
  const bool anyStress = injury.ielBreaks && injury.stressLimit > 0;
  return !(injury.removeIel || scene.stent || anyStrain || anyStress);
}

std::string flowSchedule(const Scene& scene) {
  if (!scene.hasTissue()) return "once: without tissue the lumen does not change";
  if (scene.coupling.schedule == "everyStep")
    return fmt::format("in every one of the {} steps (coupling.schedule = \"everyStep\")",
                       stepCount(scene.scene) + 1);
  std::string text = fmt::format(
      "from the first covered cell (not before day {:g}), when a covered cell could still cycle and the "
      "lumen "
      "has moved more than {:g} um over 1 % of it, or at {:g} % of the covered cells near the stress that "
      "arrests them",
      Biology(biologySettings(scene)).endotheliumOnset() / day, scene.coupling.lumenTolerance * 1e6,
      scene.coupling.undecidedShare * 100);
  if (nothingCanBeExposed(scene))
    text +=
        "; the IEL is intact, so no cell is exposed, none is covered, and the flow is expected never to be "
        "due";
  return text;
}

std::string forecastText(const Scene& scene) {
  std::string text;
  for (const std::string& known : flowForecast(scene, 1)) text += "; it " + known;
  return text;
}

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

/// Memory and time of the one solve in a lumen without tissue; empty where there is tissue, whose lumen
/// changes.
std::string flowText(const Scene& scene) {
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

/// Agents, memory and time of the tissue, or empty where there is none; and what is to be said of a loaded
/// wall.
std::string tissueText(const Scene& scene, std::uint32_t steps) {
  if (!scene.hasTissue()) return "";
  const CostEstimate cost;
  const bool loaded = !scene.vessel.agents.empty();
  const AgentStore wall = loaded ? readAgentTable(scene.vessel.agents).agents : AgentStore();
  const double ofWall = loaded ? wall.size() : packedAgents(scene);
  const double agents = ofWall + strutAgents(scene);
  const double packing = loaded ? 0 : cost.packSecondsPerAgent;
  const double deploySteps = scene.stent ? static_cast<double>(scene.stent->deploymentSteps) : 0;
  const double seconds = agents * (packing + deploySteps * cost.deploySecondsPerStep +
                                   (scene.cellCycle ? steps * cost.growSecondsPerStep : 0));
  const double bytes = cost.programBytes + agents * cost.bytesPerAgent +
                       static_cast<double>(lumenGrid(scene).size()) * cost.bytesPerNode;
  std::string text = fmt::format(
      "{}{:.0f} agents{}, {:.0f} MB, {:.0f} s on two cores without flow (rough estimates)\n",
      loaded ? "" : "about ", agents,
      agents > ofWall ? fmt::format(" ({:.0f} of them struts)", agents - ofWall) : "", bytes / 1e6, seconds);
  if (const std::string ends = remarkOnOpenEnds(scene.vessel, wall); !ends.empty()) text += ends + "\n";
  return text;
}

}  // namespace

std::vector<PlannedPart> planParts(const Scene& scene) {
  std::vector<PlannedPart> parts;
  const auto add = [&parts](std::string name, bool runs, std::string explanation) {
    parts.push_back({std::move(name), runs, std::move(explanation)});
  };
  const bool tissue = scene.hasTissue(), cycle = scene.cellCycle.has_value();
  add("wall", tissue,
      scene.hasLoadedLumen() ? "no [mechanics], so no tissue: the lumen is " + scene.vessel.lumenSurface
      : !tissue              ? "no [mechanics], so no tissue: the lumen is the vessel's own shape"
      : !scene.vessel.lumenSurface.empty()
          ? fmt::format("packed once around {}, then relaxed", scene.vessel.lumenSurface)
      : scene.vessel.agents.empty() ? "packed once, then relaxed"
                                    : "loaded as it stands from " + scene.vessel.agents);
  add("deployment", scene.stent.has_value(),
      scene.stent ? fmt::format("{} steps to {:g} um, the wall relaxing after each",
                                scene.stent->deploymentSteps, scene.stent->deploymentDepth * 1e6)
                  : "no [stent]");
  add("injury", scene.injury.has_value(),
      scene.injury ? "once, after deployment" : "no [injury], so no cell becomes synthetic");
  add("relaxation", cycle,
      cycle ? "after every step in which a cell grew or divided" : "no [cellCycle]: nothing grows");
  add("contact inhibition", cycle && scene.contactInhibition,
      !cycle                    ? "no [cellCycle]"
      : scene.contactInhibition ? "in every step in which an agent moved"
                                : "no [contactInhibition]: no cell is inhibited");
  const double onset = scene.endothelium ? Biology(biologySettings(scene)).endotheliumOnset() : 0;
  add("endothelium", cycle && scene.endothelium && std::isfinite(onset),
      !scene.endothelium ? "no [endothelium], so no nitric oxide"
      : !cycle           ? "no [cellCycle]"
      : std::isinf(onset)
          ? fmt::format("\"{}\": it never returns", scene.endothelium->scenario)
          : fmt::format("\"{}\", in every step from day {:g}", scene.endothelium->scenario, onset / day));
  const std::string noFlow = noFlowBecause(scene);
  add("lumen surface", true,
      noFlow.empty() ? "when the flow may be due, and at recorded steps" : "at recorded steps only");
  add("flow" + (noFlow.empty() ? " (" + scene.flow->backend + ")" : ""), noFlow.empty(),
      noFlow.empty() ? flowSchedule(scene) + forecastText(scene) : noFlow);
  if (noFlow.empty() && scene.flow->backend == flowBackendNames::foam && tissue)
    add("mesh", true,
        scene.coupling.remesh == "always"
            ? "made anew for every solve"
            : "moved with the wall, and made anew where that is not good enough");
  if (noFlow.empty() && scene.flow->backend == flowBackendNames::lbm && scene.coupling.remesh != "always")
    add("mesh", false, "coupling.remesh is about OpenFOAM's mesh: a lattice is made anew for every solve");
  if (noFlow.empty() && scene.flow->straightEnds > 0)
    add("straight ends", true,
        fmt::format("{:g} mm of straight tube before the inlet and behind the outlet, in the flow only",
                    scene.flow->straightEnds * 1e3));
  add("nitric oxide", noFlow.empty() && tissue,
      noFlow.empty() && tissue ? "after the endothelium, from the last flow's wall shear stress"
                               : "no wall shear stress");
  add("cell cycle", cycle, cycle ? "in every step" : "no [cellCycle]");
  return parts;
}

std::string surfacesText(const Scene& scene) {
  std::string text;
  if (!scene.lumenParts.empty()) text += fmt::format("lumen of {}:\n", scene.vessel.lumenSurface);
  for (const std::string& part : scene.lumenParts) text += fmt::format("  {}\n", part);
  if (!scene.stent) return text;
  if (const std::string struts = describeStentFile(*scene.stent); !struts.empty())
    text += fmt::format("stent of {}:\n  {:<7} {}\n", scene.stent->file, "strut", struts);
  return text;
}

std::string planText(const Scene& scene) {
  const std::uint32_t steps = stepCount(scene.scene);
  std::string text = fmt::format("{}: {}\n", printable(scene.file.string()), printable(scene.scene.title));
  text += fmt::format("vessel {:g} mm long, lumen {:g} mm; {:g} days in {} steps of {:g} h; fidelity {}\n",
                      scene.vessel.length * 1e3, scene.vessel.lumenDiameter * 1e3, scene.scene.duration / day,
                      steps, scene.scene.step / 3600, scene.scene.fidelity);
  text += surfacesText(scene);
  for (const std::string& remark : scene.remarks) text += remark + "\n";
  for (const PlannedPart& part : planParts(scene))
    text +=
        fmt::format("  {:<5}{:<20} {}\n", part.runs ? "runs" : "-", part.name, printable(part.explanation));
  return text + flowText(scene) + tissueText(scene, steps);
}

}  // namespace restenosis
