#pragma once

#include <optional>
#include <string>

#include "Scene.h"
#include "Units.h"

namespace restenosis {

/// Why the scene's flow backend would refuse the lumen, known before anything has run.
struct ResolutionProblem {
  std::string key;  ///< to blame, with its section, as in "lbm.dx"
  std::string message;
};

/// Compares the lumen before stenting with what the backend needs: cells or nodes across its inlet, and their
/// number in all, which is estimated from below. Nothing where it may do, and for lumens from a surface,
/// whose shape only the backend measures.
std::optional<ResolutionProblem> resolutionProblem(const Scene& scene, const Units& units);

}  // namespace restenosis
