#pragma once

#include <optional>
#include <string>

#include "bridge/scene/Scene.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// Why the scene's flow backend would refuse the lumen, known before anything has run.
struct ResolutionProblem {
  std::string key;  ///< to blame, with its section, as in "lbm.dx"
  std::string message;
};

/// What is known of a lumen from a surface.
struct LoadedExtent {
  double diameter;  ///< of the circle of its inlet's area [m]
  double length;    ///< along it, from above [m]
  double volume;    ///< [m^3]
};

/// Compares the lumen before stenting with what the backend needs: cells or nodes across its inlet and along
/// it, and their number in all, which is estimated from below. Nothing where it may do, and for lumens from a
/// surface without their extent, which only the surface tells.
std::optional<ResolutionProblem> resolutionProblem(const Scene& scene, const Units& units,
                                                   const std::optional<LoadedExtent>& loaded = {});

}  // namespace restenosis
