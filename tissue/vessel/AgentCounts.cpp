#include "AgentCounts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace restenosis {

AgentCounts countAgents(const VesselParameters& vessel) {
  using std::numbers::pi;
  const double r = vessel.cellRadius, spread2 = vessel.radiusSpread * vessel.radiusSpread;
  const double inner = vessel.lumenDiameter / 2, outer = inner + vessel.wallThickness;
  const double meanVolume = 4.0 / 3.0 * pi * r * r * r * (1 + 3 * spread2);
  const double meanDisc = pi * r * r * (1 + spread2);
  const double total =
      vessel.packingFraction * pi * (outer * outer - inner * inner) * vessel.length / meanVolume;
  const auto onLamina = [&](double radius) {
    return static_cast<Index>(
        std::lround(vessel.laminaCoverage * 2 * pi * radius * vessel.length / meanDisc));
  };
  AgentCounts counts{.iel = onLamina(ielRadius(vessel)), .eel = onLamina(eelRadius(vessel))};
  const double smc = std::round(total) - counts.iel - counts.eel;
  if (smc < 0 || eelRadius(vessel) - ielRadius(vessel) < 2 * r) {
    throw std::invalid_argument(
        fmt::format("a wall of {:.4g} um has no room for cells of radius {:.4g} um between its laminae: make "
                    "vessel.wallThickness or vessel.packingFraction larger, or vessel.cellRadius or "
                    "vessel.laminaCoverage smaller",
                    vessel.wallThickness * 1e6, r * 1e6));
  }
  counts.smc = static_cast<Index>(smc);
  return counts;
}

}  // namespace restenosis
