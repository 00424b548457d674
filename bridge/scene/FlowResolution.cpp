#include "bridge/scene/FlowResolution.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "bridge/flow/FlowBackendNames.h"

namespace restenosis {
namespace {

/// By how much the inlet of a wall of agents may be wider than its nominal diameter (assumed), and any other
/// by round-off.
constexpr double widestOfAgents = 1.1, widest = 1 + 1e-6;
/// Fewest cells of the core along the lumen (assumed).
constexpr double leastCellsAlong = 0.5;

/// What a backend asks for.
struct Needs {
  bool given;                            ///< whether the scene has the backend's section
  std::string_view section, size, most;  ///< keys
  const char* pieces;                    ///< "cells" or "nodes"
  double piece;                          ///< size of one [m]
  double leastAcross, leastAlong;        ///< in pieces
  double filled;                         ///< with pieces, at least [m^3]
  double mostNumber;                     ///< of pieces
};

/// What the flow is solved in.
struct Tube {
  double diameter, widest;      ///< [m], and by how much it may be wider
  double length, straightEnds;  ///< [m]; straightEnds: both together
  std::string_view lengthKey;   ///< to blame for its length
};

std::optional<ResolutionProblem> problemOf(const Needs& needs, const Tube& tube, const Units& units) {
  const double across = tube.diameter / needs.piece, along = (tube.length + tube.straightEnds) / needs.piece;
  const double number = needs.filled / std::pow(needs.piece, 3);
  const std::string key = needs.given ? fmt::format("{}.{}", needs.section, needs.size) : "scene.fidelity";
  const std::string size =
      fmt::format("'{}' in [{}] is {:.6g} um", needs.size, needs.section, units.fromSi(needs.piece, "um"));
  const std::string lumen = fmt::format("a lumen of {:.4g} mm", units.fromSi(tube.diameter, "mm"));
  const std::string length =
      fmt::format("{:.4g} mm length{}", units.fromSi(tube.length + tube.straightEnds, "mm"),
                  tube.straightEnds > 0 ? ", straight ends included," : "");
  if (tube.widest * across < needs.leastAcross)
    return ResolutionProblem{key, fmt::format("{}: {} has {:.2g} {} across, at least {:.4g} are needed", size,
                                              lumen, across, needs.pieces, needs.leastAcross)};
  if (along < needs.leastAlong)
    return ResolutionProblem{
        std::string(tube.lengthKey),
        fmt::format("a lumen of {} has {:.2g} {} along it, at least {:.4g} are needed: {}", length, along,
                    needs.pieces, needs.leastAlong, size)};
  if (number > needs.mostNumber)
    return ResolutionProblem{
        key, fmt::format("{}: {} and {} takes at least {:.2g} {}, more than '{}' = {:.2g}", size, lumen,
                         length, number, needs.pieces, needs.most, needs.mostNumber)};
  return {};
}

}  // namespace

std::optional<ResolutionProblem> resolutionProblem(const Scene& scene, const Units& units,
                                                   const std::optional<LoadedExtent>& loaded) {
  const VesselParameters& vessel = scene.vessel;
  if (!scene.flow || (!vessel.lumenSurface.empty() && !loaded)) return {};
  const double diameter = loaded ? loaded->diameter : vessel.lumenDiameter;
  const double square = diameter * diameter, section = std::numbers::pi / 4 * square;
  const Tube tube{diameter, scene.hasTissue() ? widestOfAgents : widest,
                  loaded ? loaded->length : vessel.length, 2 * scene.flow->straightEnds,
                  loaded ? "vessel.lumenSurface" : "vessel.length"};
  if (scene.flow->backend == flowBackendNames::lbm) {
    const LbmSettings lbm = scene.lbmSettings();
    const double box =
        loaded ? loaded->volume + section * tube.straightEnds : square * (tube.length + tube.straightEnds);
    return problemOf({scene.lbm.has_value(), LbmSettings::section, "dx", "maximumNodes", "nodes", lbm.dx,
                      LbmSettings::leastNodesAcross, LbmSettings::leastNodesAlong, box, lbm.maximumNodes},
                     tube, units);
  }
  if (scene.flow->backend == flowBackendNames::foam) {
    const FoamSettings foam = scene.foamSettings();
    // The core only, as narrow as a stenosis all along the vessel; what is finer at the wall comes on top.
    const double narrowest =
        loaded ? loaded->volume : section * tube.length * std::pow(1 - vessel.stenosis, 2);
    return problemOf({scene.foam.has_value(), FoamSettings::section, "cellSize", "maximumCells", "cells",
                      foam.cellSize, foam.minimumCellsAcross, leastCellsAlong,
                      narrowest + section * tube.straightEnds, foam.maximumCells},
                     tube, units);
  }
  return {};
}

}  // namespace restenosis
