#pragma once

#include <optional>
#include <string>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// How far the area of the neointima is off, as shares of it.
struct FidelityError {
  double area = 0;   ///< from that at `reference`
  double seeds = 0;  ///< half the range of three seeds: what one run cannot tell from nothing
};

/// What was measured of the scene's fidelity, in one ring over 28 days with flow by OpenFOAM
/// (docs/results/coupling.md). Nothing for a scene that sets keys which a fidelity decides, or whose kind was
/// not measured.
std::optional<FidelityError> fidelityError(const Scene& scene);

/// The same in words, a line; or empty.
std::string fidelityErrorText(const Scene& scene);

}  // namespace restenosis
