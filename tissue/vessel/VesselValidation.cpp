#include "VesselValidation.h"

#include <fmt/format.h>

#include <algorithm>

#include "AgentCounts.h"
#include "LengthUnits.h"
#include "Limit.h"
#include "StentDesign.h"
#include "WallTable.h"

namespace restenosis {
namespace {

class Validation {
 public:
  explicit Validation(const KeyIsKnown& known) : known_(known) {}

  std::vector<ParameterProblem> problems;

  void checkVessel(const VesselParameters& v, const StentParameters* s) {
    if (!v.agents.empty() && !v.lumenSurface.empty()) {
      add({"vessel.lumenSurface",
           "a vessel is made of 'agents' or has a 'lumenSurface', not both",
           {"vessel.agents"}});
    }
    if (v.length <= 2 * v.fixedEnds * v.cellRadius) {
      add({"vessel.length",
           fmt::format(
               "{:.4g} mm is no longer than the two fixed ends of {:.4g} cell radii (together {:.4g} mm); "
               "make it longer, or vessel.fixedEnds smaller",
               v.length / mm, v.fixedEnds, 2 * v.fixedEnds * v.cellRadius / mm),
           {"vessel.fixedEnds", "vessel.cellRadius"}});
    }
    if (v.stenosis > 0 && exceeds(v.stenosisLength, v.length)) {
      add({"vessel.stenosisLength",
           fmt::format("{:.4g} mm is longer than the vessel ({:.4g} mm)", v.stenosisLength / mm,
                       v.length / mm),
           {"vessel.stenosis", "vessel.length"}});
    }
    if (!v.agents.empty()) {
      checkWall(v, s);
    } else {
      checkCounts(v);
    }
  }

  void checkStent(const StentParameters& s, const VesselParameters& v) {
    checkDepth(s, v);
    if (!s.file.empty()) return;
    if (s.strutThickness >= v.lumenDiameter / 2) {
      add({"stent.strutThickness",
           fmt::format("a strut {:.4g} mm thick does not fit a lumen of radius {:.4g} mm (half of "
                       "vessel.lumenDiameter); allowed is less",
                       s.strutThickness / mm, v.lumenDiameter / 2 / mm),
           {"vessel.lumenDiameter"}});
    }
    if (!known_("stent.design")) return;
    const StentDesign& design = stentDesign(s.design);
    if (design.spansLength && exceeds(s.length, v.length)) {
      add({"stent.length",
           fmt::format("a stent of {:.6g} mm is longer than the vessel ({:.6g} mm); allowed is "
                       "at most vessel.length",
                       s.length / mm, v.length / mm),
           {"stent.design", "vessel.length"}});
    }
    for (ParameterProblem& problem : design.check(s, v)) add(std::move(problem));
  }

 private:
  void add(ParameterProblem problem) {
    if (known_(problem.key) && std::ranges::all_of(problem.others, known_))
      problems.push_back(std::move(problem));
  }

  void checkCounts(const VesselParameters& v) {
    try {
      countAgents(v, cylindricalShape(v));
    } catch (const std::invalid_argument& error) {
      add({"vessel.wallThickness",
           error.what(),
           {"vessel.agents", "vessel.cellRadius", "vessel.radiusSpread", "vessel.packingFraction",
            "vessel.laminaCoverage", "vessel.length", "vessel.lumenDiameter"}});
    }
  }

  void checkWall(const VesselParameters& v, const StentParameters* s) {
    for (const char* key : {"vessel.agents", "vessel.cellRadius", "vessel.length", "vessel.lumenDiameter",
                            "vessel.wallThickness"})
      if (!known_(key)) return;
    try {
      // Without its depth nothing can be said of the place that the stent is pressed to
      readWallTable(v, known_("stent.deploymentDepth") ? s : nullptr);
    } catch (const AgentTableError& error) {
      add({"vessel.agents", error.what()});
    }
  }

  void checkDepth(const StentParameters& s, const VesselParameters& v) {
    const double deepest = v.wallThickness - 2 * v.cellRadius;
    if (exceeds(s.deploymentDepth, deepest)) {
      add({"stent.deploymentDepth",
           fmt::format("{:.6g} um is beyond the wall: at most {} um leave the EEL (vessel.wallThickness less "
                       "a cell's diameter)",
                       s.deploymentDepth / um, shownAtMost(deepest / um)),
           {"vessel.wallThickness", "vessel.cellRadius"}});
    }
  }

  const KeyIsKnown& known_;
};

}  // namespace

std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent,
                                       const KeyIsKnown& known) {
  Validation validation(known);
  validation.checkVessel(vessel, stent);
  if (stent) validation.checkStent(*stent, vessel);
  return std::move(validation.problems);
}

}  // namespace restenosis
