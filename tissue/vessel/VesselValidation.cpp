#include "tissue/vessel/VesselValidation.h"

#include <fmt/format.h>

#include <stdexcept>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Limit.h"
#include "tissue/vessel/AgentCounts.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

void checkCounts(const VesselParameters& v, ParameterProblems& problems) {
  try {
    countAgents(v, cylindricalShape(v));
  } catch (const std::invalid_argument& error) {
    problems.add({"vessel.wallThickness",
                  error.what(),
                  {"vessel.agents", "vessel.cellRadius", "vessel.radiusSpread", "vessel.packingFraction",
                   "vessel.laminaCoverage", "vessel.length", "vessel.lumenDiameter"}});
  }
}

void checkWall(const VesselParameters& v, std::optional<double> depth, ParameterProblems& problems) {
  for (const char* key : {"vessel.agents", "vessel.cellRadius", "vessel.length", "vessel.lumenDiameter",
                          "vessel.wallThickness"})
    if (!problems.known(key)) return;
  try {
    // Without a valid depth the stent's final place is not checked
    if (!problems.known("stent.deploymentDepth")) depth.reset();
    readWallTable(v, depth);
  } catch (const TableError& error) {
    problems.add({"vessel.agents", error.what()});
  }
}

}  // namespace

void checkVessel(const VesselParameters& v, std::optional<double> deploymentDepth,
                 ParameterProblems& problems) {
  if (!v.agents.empty() && !v.lumenSurface.empty()) {
    problems.add({"vessel.lumenSurface",
                  "a vessel is made of 'agents' or has a 'lumenSurface', not both",
                  {"vessel.agents"}});
  }
  if (v.length <= 2 * v.fixedEnds * v.cellRadius) {
    problems.add(
        {"vessel.length",
         fmt::format(
             "{:.4g} mm is no longer than the two fixed ends of {:.4g} cell radii (together {:.4g} mm); "
             "make it longer, or vessel.fixedEnds smaller",
             v.length / mm, v.fixedEnds, 2 * v.fixedEnds * v.cellRadius / mm),
         {"vessel.fixedEnds", "vessel.cellRadius"}});
  }
  if (v.stenosis > 0 && exceeds(v.stenosisLength, v.length)) {
    problems.add(
        {"vessel.stenosisLength",
         fmt::format("{:.4g} mm is longer than the vessel ({:.4g} mm)", v.stenosisLength / mm, v.length / mm),
         {"vessel.stenosis", "vessel.length"}});
  }
  if (!v.agents.empty()) {
    checkWall(v, deploymentDepth, problems);
  } else {
    checkCounts(v, problems);
  }
}

}  // namespace restenosis
