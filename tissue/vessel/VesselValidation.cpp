#include "VesselValidation.h"

#include <fmt/format.h>

#include "AgentCounts.h"
#include "StentDesign.h"
#include "WallTable.h"

namespace restenosis {
namespace {

constexpr double mm = 1e-3, um = 1e-6;

class Validation {
 public:
  std::vector<ParameterProblem> problems;

  void checkVessel(const VesselParameters& v, const StentParameters* s) {
    if (!v.agents.empty() && !v.lumenSurface.empty()) {
      add("vessel.lumenSurface", "a vessel is made of 'agents' or has a 'lumenSurface', not both");
    }
    if (v.length <= 2 * v.fixedEnds * v.cellRadius) {
      add("vessel.length",
          fmt::format(
              "{:.4g} mm is no longer than the two fixed ends of {:.4g} cell radii (together {:.4g} mm); "
              "make it longer, or vessel.fixedEnds smaller",
              v.length / mm, v.fixedEnds, 2 * v.fixedEnds * v.cellRadius / mm));
    }
    if (v.stenosis > 0 && v.stenosisLength > v.length) {
      add("vessel.stenosisLength", fmt::format("{:.4g} mm is longer than the vessel ({:.4g} mm)",
                                               v.stenosisLength / mm, v.length / mm));
    }
    if (!v.agents.empty()) {
      checkWall(v, s);
    } else {
      try {
        countAgents(v, cylindricalShape(v));
      } catch (const std::invalid_argument& error) {
        add("vessel.wallThickness", error.what());
      }
    }
  }

  void checkStent(const StentParameters& s, const VesselParameters& v) {
    checkDepth(s, v);
    if (!s.file.empty()) return;
    if (s.strutThickness >= v.lumenDiameter / 2) {
      add("stent.strutThickness",
          fmt::format("a strut {:.4g} mm thick does not fit a lumen of radius {:.4g} mm (half of "
                      "vessel.lumenDiameter); allowed is less",
                      s.strutThickness / mm, v.lumenDiameter / 2 / mm));
    }
    const StentDesign& design = stentDesign(s.design);
    if (design.spansLength && s.length > v.length) {
      add("stent.length",
          fmt::format("a stent of {:.4g} mm is longer than the vessel ({:.4g} mm); allowed is "
                      "at most vessel.length",
                      s.length / mm, v.length / mm));
    }
    for (ParameterProblem& problem : design.check(s, v)) problems.push_back(std::move(problem));
  }

 private:
  void add(std::string key, std::string message) { problems.push_back({std::move(key), std::move(message)}); }

  void checkWall(const VesselParameters& v, const StentParameters* s) {
    try {
      readWallTable(v, s);
    } catch (const AgentTableError& error) {
      add("vessel.agents", error.what());
    }
  }

  void checkDepth(const StentParameters& s, const VesselParameters& v) {
    const double deepest = v.wallThickness - 2 * v.cellRadius;
    if (s.deploymentDepth > deepest) {
      add("stent.deploymentDepth",
          fmt::format(
              "{:.4g} um is beyond the wall: at most {:.4g} um leave the EEL (vessel.wallThickness less "
              "a cell's diameter)",
              s.deploymentDepth / um, deepest / um));
    }
  }
};

}  // namespace

std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent) {
  Validation validation;
  validation.checkVessel(vessel, stent);
  if (stent) validation.checkStent(*stent, vessel);
  return std::move(validation.problems);
}

}  // namespace restenosis
