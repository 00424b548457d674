#include "tissue/vessel/AgentCounts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace restenosis {

AgentCounts countAgents(const VesselParameters& vessel, const WallShape& shape) {
  using std::numbers::pi;
  const double r = vessel.cellRadius, spread2 = vessel.radiusSpread * vessel.radiusSpread;
  const double meanVolume = 4.0 / 3.0 * pi * r * r * r * (1 + 3 * spread2);
  const double meanDisc = pi * r * r * (1 + spread2);
  const double total = vessel.packingFraction * shape.volume / meanVolume;
  const auto onLamina = [&](double area) {
    return static_cast<Index>(std::lround(vessel.laminaCoverage * area / meanDisc));
  };
  AgentCounts counts{.iel = onLamina(shape.ielArea), .eel = onLamina(shape.eelArea)};
  const double smc = std::round(total) - counts.iel - counts.eel;
  if (smc < 0 || vessel.wallThickness < 4 * r * (1 - 1e-9)) {
    throw std::invalid_argument(fmt::format(
        "a wall of {:.4g} um has no space for cells of radius {:.4g} um between its laminae: make "
        "vessel.wallThickness or vessel.packingFraction larger, or vessel.cellRadius or "
        "vessel.laminaCoverage smaller",
        vessel.wallThickness * 1e6, r * 1e6));
  }
  counts.smc = static_cast<Index>(smc);
  return counts;
}

}  // namespace restenosis
