#include "SceneChecks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace restenosis {
namespace {

/// Limits that keep a slip of the keyboard from filling a machine: assumed, far beyond any use.
constexpr double mostAgents = 20e6, mostSteps = 10e6;

using Finding = std::optional<std::string>;

/// One rule. `reads` are the keys it looks at, "section" or "section.key"; the first is the one to blame.
struct Check {
  std::vector<std::string_view> reads;
  Finding (*find)(const Scene& scene, const Units& units);
};

bool hasPackedWall(const Scene& s) { return s.hasTissue() && s.vessel.agents.empty(); }

Finding durationBelowStep(const Scene& s, const Units& u) {
  if (s.scene.duration >= s.scene.step) return {};
  return fmt::format("'duration' is {}, shorter than one step of {}", u.format(s.scene.duration, "h"),
                     u.format(s.scene.step, "h"));
}

Finding durationBetweenSteps(const Scene& s, const Units& u) {
  const double steps = s.scene.duration / s.scene.step;
  if (steps < 1 || std::abs(steps - std::round(steps)) < 1e-9 * steps) return {};
  return fmt::format("'duration' is {}, not a whole number of steps of {}", u.format(s.scene.duration, "h"),
                     u.format(s.scene.step, "h"));
}

Finding tooManySteps(const Scene& s, const Units& u) {
  const double steps = s.scene.duration / s.scene.step;
  if (steps <= mostSteps) return {};
  return fmt::format("'step' of {} makes {:.3g} steps; at most {:.3g} are allowed",
                     u.format(s.scene.step, "h"), steps, mostSteps);
}

Finding needs(bool present, bool needed, std::string_view section, std::string_view other,
              std::string_view why) {
  if (!present || needed) return {};
  return fmt::format("[{}] needs [{}], which this scene does not have: {}", section, other, why);
}

Finding stentWithoutTissue(const Scene& s, const Units&) {
  return needs(s.stent.has_value(), s.hasTissue(), "stent", "mechanics", "struts are pressed into tissue");
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
Finding endotheliumWithoutCycle(const Scene& s, const Units&) {
  return needs(s.endothelium.has_value(), s.cellCycle.has_value(), "endothelium", "cellCycle",
               "its nitric oxide stops the cycle of cells");
}
Finding agentsWithoutTissue(const Scene& s, const Units&) {
  if (s.vessel.agents.empty() || s.hasTissue()) return {};
  return "'agents' needs [mechanics], which this scene does not have: agents are tissue";
}

Finding stenosisInTissue(const Scene& s, const Units&) {
  if (s.vessel.stenosis == 0 || !s.hasTissue()) return {};
  return "'stenosis' shapes a vessel without tissue; take it or [mechanics] out";
}

Finding stenosisOfLoadedLumen(const Scene& s, const Units&) {
  if (s.vessel.stenosis == 0 || s.vessel.lumenSurface.empty()) return {};
  return "'stenosis' shapes a cylinder, but 'lumenSurface' gives the lumen; take one of them out";
}

Finding stenosisTooLong(const Scene& s, const Units& u) {
  if (s.vessel.stenosis == 0 || s.vessel.stenosisLength <= s.vessel.length) return {};
  return fmt::format("'stenosisLength' is {}, longer than the vessel ({})",
                     u.format(s.vessel.stenosisLength, "mm"), u.format(s.vessel.length, "mm"));
}

Finding stentTooLong(const Scene& s, const Units& u) {
  if (!s.stent || !s.stent->file.empty() || s.stent->length <= s.vessel.length) return {};
  return fmt::format("the stent's 'length' is {}, longer than the vessel ({})",
                     u.format(s.stent->length, "mm"), u.format(s.vessel.length, "mm"));
}

Finding strutTooWide(const Scene& s, const Units& u) {
  if (!s.stent || !s.stent->file.empty() || s.stent->strutWidth < s.vessel.length) return {};
  return fmt::format("'strutWidth' is {}, but the vessel is only {} long",
                     u.format(s.stent->strutWidth, "mm"), u.format(s.vessel.length, "mm"));
}

Finding strutTooThick(const Scene& s, const Units& u) {
  if (!s.stent || !s.stent->file.empty() || s.stent->strutThickness < s.vessel.lumenDiameter / 2) return {};
  return fmt::format("'strutThickness' is {}: a strut thicker than the lumen's radius ({}) leaves no lumen",
                     u.format(s.stent->strutThickness, "mm"), u.format(s.vessel.lumenDiameter / 2, "mm"));
}

Finding deploymentTooDeep(const Scene& s, const Units& u) {
  if (!s.stent || s.stent->deploymentDepth < s.vessel.wallThickness) return {};
  return fmt::format("'deploymentDepth' is {}, but the wall is only {} thick",
                     u.format(s.stent->deploymentDepth, "um"), u.format(s.vessel.wallThickness, "um"));
}

Finding cellsTooLarge(const Scene& s, const Units& u) {
  const double largest = std::min(s.vessel.wallThickness / 6, s.vessel.length / 6);
  if (!hasPackedWall(s) || s.vessel.cellRadius <= largest * (1 + 1e-12)) return {};
  return fmt::format(
      "'cellRadius' is {}; at most {} fits IEL, one layer of cells and EEL into the wall ({}) and as many "
      "agents along the vessel ({})",
      u.format(s.vessel.cellRadius, "um"), fmt::format("{:.3g} um", u.fromSi(largest, "um")),
      u.format(s.vessel.wallThickness, "um"), u.format(s.vessel.length, "mm"));
}

Finding tooManyAgents(const Scene& s, const Units& u) {
  const double agents = estimatedAgents(s);
  if (agents <= mostAgents) return {};
  return fmt::format("cells of radius {} make about {:.2g} agents of this wall; at most {:.2g} are allowed",
                     u.format(s.vessel.cellRadius, "um"), agents, mostAgents);
}

Finding phasesBelowZero(const Scene& s, const Units& u) {
  if (!s.cellCycle || s.cellCycle->g1Mean >= 3 * s.cellCycle->g1Spread) return {};
  return fmt::format("'g1Spread' is {}, more than a third of g1Mean ({}): G1 could last less than no time",
                     u.format(s.cellCycle->g1Spread, "h"), u.format(s.cellCycle->g1Mean, "h"));
}

Finding driveWithoutGradient(const Scene& s, const Units&) {
  if (!s.flow || s.flow->drive != "pressureGradient" || s.flow->pressureGradient > 0) return {};
  return "'pressureGradient' is 0, so nothing flows with drive = \"pressureGradient\"; take [flow] out "
         "instead";
}

Finding surfaceTooCoarse(const Scene& s, const Units& u) {
  if (s.coupling.surfaceResolution <= s.vessel.lumenDiameter / 10) return {};
  return fmt::format("'surfaceResolution' is {}; a lumen of {} needs at least ten spacings across",
                     u.format(s.coupling.surfaceResolution, "um"), u.format(s.vessel.lumenDiameter, "mm"));
}

const std::vector<Check>& checks() {
  static const std::vector<Check> table = {
      {{"scene.duration", "scene.step"}, durationBelowStep},
      {{"scene.duration", "scene.step"}, durationBetweenSteps},
      {{"scene.step", "scene.duration"}, tooManySteps},
      {{"stent", "mechanics"}, stentWithoutTissue},
      {{"injury", "mechanics"}, injuryWithoutTissue},
      {{"cellCycle", "mechanics"}, cellCycleWithoutTissue},
      {{"contactInhibition", "cellCycle"}, inhibitionWithoutCycle},
      {{"endothelium", "cellCycle"}, endotheliumWithoutCycle},
      {{"vessel.agents", "mechanics"}, agentsWithoutTissue},
      {{"vessel.stenosis", "mechanics"}, stenosisInTissue},
      {{"vessel.stenosis", "vessel.lumenSurface"}, stenosisOfLoadedLumen},
      {{"vessel.stenosisLength", "vessel.stenosis", "vessel.length"}, stenosisTooLong},
      {{"stent.length", "stent.design", "stent.file", "vessel.length"}, stentTooLong},
      {{"stent.strutWidth", "stent.file", "vessel.length"}, strutTooWide},
      {{"stent.strutThickness", "stent.file", "vessel.lumenDiameter"}, strutTooThick},
      {{"stent.deploymentDepth", "vessel.wallThickness"}, deploymentTooDeep},
      {{"vessel.cellRadius", "vessel.wallThickness", "vessel.length", "vessel.agents", "mechanics"},
       cellsTooLarge},
      {{"vessel.cellRadius", "vessel.wallThickness", "vessel.length", "vessel.lumenDiameter",
        "vessel.packingFraction", "vessel.agents", "mechanics"},
       tooManyAgents},
      {{"cellCycle.g1Spread", "cellCycle.g1Mean"}, phasesBelowZero},
      {{"flow.pressureGradient", "flow.drive"}, driveWithoutGradient},
      {{"coupling.surfaceResolution", "vessel.lumenDiameter"}, surfaceTooCoarse},
  };
  return table;
}

std::string_view sectionOf(std::string_view key) { return key.substr(0, key.find('.')); }

}  // namespace

double estimatedAgents(const Scene& scene) {
  if (!hasPackedWall(scene)) return 0;
  const VesselParameters& v = scene.vessel;
  const double inner = v.lumenDiameter / 2, outer = inner + v.wallThickness;
  const double wallVolume = std::numbers::pi * (outer * outer - inner * inner) * v.length;
  return v.packingFraction * wallVolume / (4.0 / 3.0 * std::numbers::pi * std::pow(v.cellRadius, 3));
}

void checkScene(const Scene& scene, const SceneDocument& document, const Units& units,
                SceneFindings& findings) {
  const auto unreliable = [known = findings.unreliable](std::string_view key) {
    return known.count(key) > 0 || known.count(sectionOf(key)) > 0;
  };
  for (const auto& check : checks()) {
    if (std::any_of(check.reads.begin(), check.reads.end(), unreliable)) continue;
    if (const Finding message = check.find(scene, units)) {
      const std::string_view blamed = check.reads.front(), section = sectionOf(blamed);
      findings.add(document.placeOf(section, section == blamed ? "" : blamed.substr(section.size() + 1)),
                   *message);
    }
  }
}

}  // namespace restenosis
