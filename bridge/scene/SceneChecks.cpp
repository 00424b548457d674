#include "bridge/scene/SceneChecks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/scene/ArteryWidth.h"
#include "bridge/scene/AxisChecks.h"
#include "bridge/scene/FlowChecks.h"
#include "bridge/scene/FlowResolution.h"
#include "bridge/surface/SceneStent.h"
#include "tissue/biology/NitricOxide.h"
#include "tissue/parameters/Limit.h"
#include "tissue/stent/StentDesign.h"
#include "tissue/stent/StentValidation.h"

namespace restenosis {
namespace {

/// Limits that keep a slip of the keyboard from filling a machine: assumed, far beyond any use.
constexpr double mostAgents = 20e6, mostSteps = 10e6;

bool hasPackedWall(const Scene& s) { return s.hasTissue() && s.vessel.agents.empty(); }

Finding durationBelowStep(const Scene& s, const Units& u) {
  if (s.scene.duration >= s.scene.step) return {};
  return fmt::format("'duration' in [scene] is {}, shorter than one step of {}",
                     shownIn(u, s.scene.duration, "h"), shownIn(u, s.scene.step, "h"));
}

Finding durationBetweenSteps(const Scene& s, const Units& u) {
  const double steps = s.scene.duration / s.scene.step;
  if (steps < 1 || std::abs(steps - std::round(steps)) < 1e-9 * steps) return {};
  return fmt::format(
      "'duration' in [scene] is {}, not a whole number of steps of {}; the nearest allowed are {} and {}",
      shownIn(u, s.scene.duration, "h"), shownIn(u, s.scene.step, "h"),
      u.format(std::floor(steps) * s.scene.step, "h"), u.format(std::ceil(steps) * s.scene.step, "h"));
}

Finding tooManySteps(const Scene& s, const Units& u) {
  const double steps = s.scene.duration / s.scene.step;
  if (steps <= mostSteps) return {};
  return fmt::format("'step' in [scene] of {} makes {:.3g} steps; at most {:.3g} are allowed",
                     shownIn(u, s.scene.step, "h"), steps, mostSteps);
}

Finding needs(bool present, bool needed, std::string_view section, std::string_view other,
              std::string_view why) {
  if (!present || needed) return {};
  return fmt::format("[{}] needs [{}], which this scene does not have: {}", section, other, why);
}

Finding stentWithoutTissue(const Scene& s, const Units&) {
  return needs(s.stent.has_value(), s.hasTissue(), "stent", "mechanics", "struts are pressed into tissue");
}
Finding relaxationWithoutTissue(const Scene& s, const Units&) {
  return needs(s.relaxation.has_value(), s.hasTissue(), "relaxation", "mechanics", "only tissue is relaxed");
}
Finding injuryWithoutTissue(const Scene& s, const Units&) {
  return needs(s.injury.has_value(), s.hasTissue(), "injury", "mechanics", "injury happens to tissue");
}
Finding cellCycleWithoutTissue(const Scene& s, const Units&) {
  return needs(s.cellCycle.has_value(), s.hasTissue(), "cellCycle", "mechanics", "only tissue has cells");
}
Finding inhibitionWithoutCycle(const Scene& s, const Units&) {
  return needs(s.contactInhibition.has_value(), s.cellCycle.has_value(), "contactInhibition", "cellCycle",
               "there is nothing to inhibit");
}
Finding activationWithoutCycle(const Scene& s, const Units&) {
  return needs(s.activation.has_value(), s.cellCycle.has_value(), "activation", "cellCycle",
               "it tells cells when to cycle");
}
Finding matrixWithoutCycle(const Scene& s, const Units&) {
  return needs(s.extracellularMatrix.has_value(), s.cellCycle.has_value(), "extracellularMatrix", "cellCycle",
               "synthetic cells lay it down");
}
Finding endotheliumWithoutCycle(const Scene& s, const Units&) {
  return needs(s.endothelium.has_value(), s.cellCycle.has_value(), "endothelium", "cellCycle",
               "its nitric oxide stops the cycle of cells");
}
Finding agentsWithoutTissue(const Scene& s, const Units&) {
  if (s.vessel.agents.empty() || s.hasTissue()) return {};
  return "'agents' needs [mechanics], which this scene does not have: agents are tissue";
}

/// A design such as one ring does not use its length, but who gives one expects it to fit. (Other designs:
/// validate.)
Finding ringLongerThanVessel(const Scene& s, const Units& u) {
  if (!s.stent || !s.stent->file.empty() || stentDesign(s.stent->design).spansLength ||
      !exceeds(s.stent->length, s.vessel.length))
    return {};
  return fmt::format("'length' in [stent]: a stent of {} is longer than the vessel ({})",
                     shownIn(u, s.stent->length, "mm"), shownIn(u, s.vessel.length, "mm"));
}

Finding cellsTooLarge(const Scene& s, const Units& u) {
  const double largest = std::min(s.vessel.wallThickness / 6, s.vessel.length / 6);
  if (!hasPackedWall(s) || !exceeds(s.vessel.cellRadius, largest)) return {};
  return fmt::format(
      "'cellRadius' in [vessel] is {}; at most {} fits IEL, one layer of cells and EEL into the wall ({}) "
      "and as many "
      "agents along the vessel ({})",
      shownIn(u, s.vessel.cellRadius, "um"), shownAtMost(u.fromSi(largest, "um")) + " um",
      shownIn(u, s.vessel.wallThickness, "um"), shownIn(u, s.vessel.length, "mm"));
}

Finding tooManyAgents(const Scene& s, const Units& u) {
  const double agents = estimatedAgents(s);
  if (agents <= mostAgents) return {};
  return fmt::format("cells of radius {} make about {:.2g} agents of this wall; at most {:.2g} are allowed",
                     shownIn(u, s.vessel.cellRadius, "um"), agents, mostAgents);
}

Finding phasesBelowZero(const Scene& s, const Units& u) {
  if (!s.cellCycle || s.cellCycle->g1Mean >= 3 * s.cellCycle->g1Spread) return {};
  return fmt::format(
      "'g1Spread' in [cellCycle] is {}, more than a third of g1Mean ({}): G1 could have a negative length",
      shownIn(u, s.cellCycle->g1Spread, "h"), shownIn(u, s.cellCycle->g1Mean, "h"));
}

Finding recruitmentBesideActivation(const Scene& s, const Units&) {
  if (!s.activation || !s.cellCycle || s.cellCycle->recruitment == 0) return {};
  return "'recruitment' in [cellCycle] and [activation] both say when cells leave rest; take one of them out";
}

Finding stretchReversed(const Scene& s, const Units&) {
  if (!s.activation || s.activation->stretchOnset <= s.activation->stretchFull) return {};
  return fmt::format("'stretchFull' in [activation] is {:g}, below stretchOnset ({:g})",
                     s.activation->stretchFull, s.activation->stretchOnset);
}

Finding nitricOxideFalls(const Scene& s, const Units&) {
  if (!s.endothelium) return {};
  std::string problem = NitricOxide::problem(*s.endothelium);
  return problem.empty() ? Finding() : Finding(std::move(problem));
}

/// Of lumens that are taken from tissue; any other has its own triangles.
Finding surfaceTooCoarse(const Scene& s, const Units& u) {
  if (!s.hasTissue()) return {};
  const double coarsest = s.vessel.lumenDiameter / 10;
  if (!exceeds(s.coupling.surfaceResolution, coarsest)) return {};
  return fmt::format(
      "'surfaceResolution' in [coupling] is {}; a lumen of {} needs at least ten spacings across: at most {}",
      shownIn(u, s.coupling.surfaceResolution, "um"), shownIn(u, s.vessel.lumenDiameter, "mm"),
      shownAtMost(u.fromSi(coarsest, "um")) + " um");
}

/// Likewise. A lumen narrower than twice the smoothing's radius is taken to be closed, and tissue would seem
/// to fill it.
Finding surfaceTooSmooth(const Scene& s, const Units& u) {
  if (!s.hasTissue()) return {};
  const double smoothest = 0.4 * s.vessel.lumenDiameter;  // assumed
  if (!exceeds(s.coupling.surfaceSmoothing, smoothest)) return {};
  return fmt::format(
      "'surfaceSmoothing' in [coupling] is {}; it closes what is narrower than twice that, and so must be "
      "well "
      "below the radius of the lumen of {}: at most {}, 0.4 of its diameter",
      shownIn(u, s.coupling.surfaceSmoothing, "um"), shownIn(u, s.vessel.lumenDiameter, "mm"),
      shownAtMost(u.fromSi(smoothest, "um")) + " um");
}

const std::vector<SceneCheck>& checks() {
  static const std::vector<SceneCheck> table = {
      {{"scene.duration", "scene.step"}, durationBelowStep},
      {{"scene.duration", "scene.step"}, durationBetweenSteps},
      {{"scene.step", "scene.duration"}, tooManySteps},
      {{"stent", "mechanics"}, stentWithoutTissue},
      {{"relaxation", "mechanics"}, relaxationWithoutTissue},
      {{"injury", "mechanics"}, injuryWithoutTissue},
      {{"cellCycle", "mechanics"}, cellCycleWithoutTissue},
      {{"contactInhibition", "cellCycle"}, inhibitionWithoutCycle},
      {{"activation", "cellCycle"}, activationWithoutCycle},
      {{"extracellularMatrix", "cellCycle"}, matrixWithoutCycle},
      {{"endothelium", "cellCycle"}, endotheliumWithoutCycle},
      {{"vessel.agents", "mechanics"}, agentsWithoutTissue},
      {{"stent.length", "stent.design", "stent.file", "vessel.length"}, ringLongerThanVessel},
      {{"vessel.cellRadius", "vessel.wallThickness", "vessel.length", "vessel.agents", "mechanics"},
       cellsTooLarge},
      {{"vessel.cellRadius", "vessel.wallThickness", "vessel.length", "vessel.lumenDiameter",
        "vessel.packingFraction", "vessel.agents", "mechanics"},
       tooManyAgents},
      {{"cellCycle.g1Spread", "cellCycle.g1Mean"}, phasesBelowZero},
      {{"cellCycle.recruitment", "activation"}, recruitmentBesideActivation},
      {{"activation.stretchFull", "activation.stretchOnset"}, stretchReversed},
      {{"endothelium.nitricOxideTransition", "endothelium.nitricOxideSlope",
        "endothelium.nitricOxideConstant", "endothelium.nitricOxideFirst", "endothelium.nitricOxideSecond"},
       nitricOxideFalls},
      {{"coupling.surfaceResolution", "vessel.lumenDiameter", "mechanics"}, surfaceTooCoarse},
      {{"coupling.surfaceSmoothing", "vessel.lumenDiameter", "mechanics"}, surfaceTooSmooth},
  };
  return table;
}

std::string_view sectionOf(std::string_view key) { return key.substr(0, key.find('.')); }

/// Where the user has written the first of the keys that is in the scene: a default cannot be pointed at. The
/// section of the first if there is none.
ScenePlace placeOf(const std::vector<std::string_view>& keys, const SceneDocument& document) {
  const auto nameOf = [](std::string_view key) {
    const std::string_view section = sectionOf(key);
    return section == key ? std::string_view() : key.substr(section.size() + 1);
  };
  for (const std::string_view key : keys)
    if (const GivenValue* value = document.find(sectionOf(key), nameOf(key))) return value->place;
  return document.placeOf(sectionOf(keys.front()), "");
}

/// Adds a finding about the first of these keys, "section" or "section.key", which no later check may rely
/// on.
void blame(const std::vector<std::string_view>& keys, std::string message, const SceneDocument& document,
           SceneFindings& findings) {
  findings.add(placeOf(keys, document), std::move(message));
  findings.unreliable.emplace(keys.front());
}

bool allReliable(const SceneFindings& findings, const std::vector<std::string_view>& keys) {
  return std::ranges::all_of(keys, [&](std::string_view key) { return findings.reliable(key); });
}

/// What is wrong with the file of a stent; nothing where there is none, or it cannot be told.
std::optional<ParameterProblem> stentFileProblem(const StentParameters& stent, const VesselParameters& vessel,
                                                 const SceneFindings& findings) {
  if (stent.file.empty() ||
      !allReliable(findings, {"stent.file", "stent.fileUnit", "vessel.length", "vessel.lumenDiameter",
                              "vessel.wallThickness", "vessel.cellRadius"}))
    return {};
  try {
    makeStent(stent, vessel);
    return {};
  } catch (const std::runtime_error& error) {
    return ParameterProblem{"stent.file", error.what()};
  }
}

/// How tissue and stent fit each other, as far as the keys that it depends on are right.
void checkFit(const Scene& scene, const SceneDocument& document, SceneFindings& findings) {
  if (!scene.hasTissue() || !findings.reliable(VesselParameters::section)) return;
  const StentParameters* stent =
      scene.stent && findings.reliable(StentParameters::section) ? &*scene.stent : nullptr;
  auto problems = validate(scene.vessel, stent, [&](std::string_view key) { return findings.reliable(key); });
  if (stent)
    if (auto problem = stentFileProblem(*stent, scene.vessel, findings))
      problems.push_back(std::move(*problem));
  for (const ParameterProblem& problem : problems) {
    std::vector<std::string_view> keys = {problem.key};
    keys.insert(keys.end(), problem.others.begin(), problem.others.end());
    const std::string_view section = sectionOf(problem.key);
    blame(keys,
          fmt::format("'{}' in [{}]: {}", problem.key.substr(section.size() + 1), section, problem.message),
          document, findings);
  }
}

/// Whether the flow can be resolved, where it is solved for certain; elsewhere it may never be due, and the
/// plan says it.
void checkResolution(const Scene& scene, const SceneDocument& document, const Units& units,
                     const std::optional<LoadedExtent>& loaded, SceneFindings& findings) {
  if (scene.hasTissue() && scene.coupling.scheduleMode() != ScheduleMode::everyStep) return;
  if (!allReliable(findings, {"mechanics", "coupling.schedule", "scene.fidelity", "vessel.length",
                              "vessel.lumenDiameter", "vessel.lumenSurface", "vessel.lumenSurfaceUnit",
                              "vessel.stenosis", "flow.backend", "flow.straightEnds"}))
    return;
  const std::string backend = scene.flow ? scene.flow->backend : std::string();
  if (backend == flowBackendNames::foam &&
      !allReliable(findings, {"foam.cellSize", "foam.minimumCellsAcross", "foam.maximumCells"}))
    return;
  if (backend == flowBackendNames::lbm && !allReliable(findings, {"lbm.dx", "lbm.maximumNodes"})) return;
  auto problem = resolutionProblem(scene, units, loaded);
  if (!problem) return;
  const std::string width = remarkOnWidth(scene, loaded ? loaded->diameter : scene.vessel.lumenDiameter);
  blame({problem->key}, problem->message + (width.empty() ? "" : "; " + width), document, findings);
}

}  // namespace

double estimatedAgents(const Scene& scene) {
  if (!hasPackedWall(scene)) return 0;
  const VesselParameters& v = scene.vessel;
  const double inner = v.lumenDiameter / 2, outer = inner + v.wallThickness;
  const double wallVolume = std::numbers::pi * (outer * outer - inner * inner) * v.length;
  return v.packingFraction * wallVolume / (4.0 / 3.0 * std::numbers::pi * std::pow(v.cellRadius, 3));
}

void checkScene(const Scene& scene, const SceneDocument& document, const Units& units,
                const std::optional<LoadedExtent>& loaded, SceneFindings& findings) {
  for (const auto* table : {&checks(), &axisChecks(), &flowChecks()})
    for (const SceneCheck& check : *table) {
      if (!allReliable(findings, check.reads)) continue;
      if (Finding message = check.find(scene, units))
        blame(check.reads, std::move(*message), document, findings);
    }
  checkFit(scene, document, findings);
  checkResolution(scene, document, units, loaded, findings);
}

}  // namespace restenosis
