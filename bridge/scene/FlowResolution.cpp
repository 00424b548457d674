#include "FlowResolution.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "FlowBackendNames.h"

namespace restenosis {
namespace {

// By how much the inlet of a wall of agents may be wider than its nominal diameter (assumed).
constexpr double widest = 1.1;

/// What a backend asks for.
struct Needs {
  bool given;                            ///< whether the scene has the backend's section
  std::string_view section, size, most;  ///< keys
  const char* pieces;                    ///< "cells" or "nodes"
  double piece;                          ///< size of one [m]
  double leastAcross;
  double number, mostNumber;  ///< in all, and allowed
};

/// What the flow is solved in.
struct Tube {
  double diameter, vesselLength, straightEnds;  ///< [m]; straightEnds: both together
};

std::optional<ResolutionProblem> problemOf(const Needs& needs, const Tube& tube, const Units& units) {
  const double across = tube.diameter / needs.piece;
  const std::string key = needs.given ? fmt::format("{}.{}", needs.section, needs.size) : "scene.fidelity";
  const std::string size =
      fmt::format("'{}' in [{}] is {:.6g} um", needs.size, needs.section, units.fromSi(needs.piece, "um"));
  const std::string lumen = fmt::format("a lumen of {:.4g} mm", units.fromSi(tube.diameter, "mm"));
  if (widest * across < needs.leastAcross)
    return ResolutionProblem{key, fmt::format("{}: {} has {:.2g} {} across, at least {:.4g} are needed", size,
                                              lumen, across, needs.pieces, needs.leastAcross)};
  if (needs.number > needs.mostNumber)
    return ResolutionProblem{
        key, fmt::format("{}: {} and {:.4g} mm length{} takes at least {:.2g} {}, more than '{}' = {:.2g}",
                         size, lumen, units.fromSi(tube.vesselLength + tube.straightEnds, "mm"),
                         tube.straightEnds > 0 ? ", straight ends included," : "", needs.number, needs.pieces,
                         needs.most, needs.mostNumber)};
  return {};
}

}  // namespace

std::optional<ResolutionProblem> resolutionProblem(const Scene& scene, const Units& units) {
  if (!scene.flow || !scene.vessel.lumenSurface.empty()) return {};
  const Tube tube{scene.vessel.lumenDiameter, scene.vessel.length, 2 * scene.flow->straightEnds};
  const double square = tube.diameter * tube.diameter;
  if (scene.flow->backend == flowBackendNames::lbm) {
    const LbmSettings lbm = scene.lbmSettings();
    const double box = square * (tube.vesselLength + tube.straightEnds);
    return problemOf({scene.lbm.has_value(), LbmSettings::section, "dx", "maximumNodes", "nodes", lbm.dx,
                      LbmSettings::leastNodesAcross, box / std::pow(lbm.dx, 3), lbm.maximumNodes},
                     tube, units);
  }
  if (scene.flow->backend == flowBackendNames::foam) {
    const FoamSettings foam = scene.foamSettings();
    // The core only, as narrow as a stenosis all along the vessel; what is finer at the wall comes on top.
    const double length = tube.vesselLength * std::pow(1 - scene.vessel.stenosis, 2) + tube.straightEnds;
    const double core = std::numbers::pi / 4 * square * length;
    return problemOf(
        {scene.foam.has_value(), FoamSettings::section, "cellSize", "maximumCells", "cells", foam.cellSize,
         foam.minimumCellsAcross, core / std::pow(foam.cellSize, 3), foam.maximumCells},
        tube, units);
  }
  return {};
}

}  // namespace restenosis
