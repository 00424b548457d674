#include "tissue/stent/StentValidation.h"

#include <fmt/format.h>

#include <utility>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Limit.h"
#include "tissue/stent/StentDesign.h"
#include "tissue/vessel/VesselValidation.h"

namespace restenosis {
namespace {

void checkDepth(const StentParameters& s, const VesselParameters& v, ParameterProblems& problems) {
  const double deepest = v.wallThickness - 2 * v.cellRadius;
  if (exceeds(s.deploymentDepth, deepest)) {
    problems.add(
        {"stent.deploymentDepth",
         fmt::format("{:.6g} um is beyond the wall: at most {} um leave the EEL (vessel.wallThickness less "
                     "a cell's diameter)",
                     s.deploymentDepth / um, shownAtMost(deepest / um)),
         {"vessel.wallThickness", "vessel.cellRadius"}});
  }
}

void checkStent(const StentParameters& s, const VesselParameters& v, ParameterProblems& problems) {
  checkDepth(s, v, problems);
  if (!s.file.empty()) return;
  if (s.strutThickness >= v.lumenDiameter / 2) {
    problems.add({"stent.strutThickness",
                  fmt::format("a strut {:.4g} mm thick does not fit a lumen of radius {:.4g} mm (half of "
                              "vessel.lumenDiameter); allowed is less",
                              s.strutThickness / mm, v.lumenDiameter / 2 / mm),
                  {"vessel.lumenDiameter"}});
  }
  if (!problems.known("stent.design")) return;
  const StentDesign& design = stentDesign(s.design);
  if (design.spansLength && exceeds(s.length, v.length)) {
    problems.add({"stent.length",
                  fmt::format("a stent of {:.6g} mm is longer than the vessel ({:.6g} mm); allowed is "
                              "at most vessel.length",
                              s.length / mm, v.length / mm),
                  {"stent.design", "vessel.length"}});
  }
  for (ParameterProblem& problem : design.check(s, v)) problems.add(std::move(problem));
}

}  // namespace

std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent,
                                       const KeyIsKnown& known) {
  ParameterProblems problems(known);
  std::optional<double> depth;
  if (stent) depth = stent->deploymentDepth;
  checkVessel(vessel, depth, problems);
  if (stent) checkStent(*stent, vessel, problems);
  return problems.extract();
}

}  // namespace restenosis
