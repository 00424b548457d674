#pragma once

#include <array>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis::support {

/// Appends free synthetic SMC of radius `radius` with centres at random in [0, side]^3 no nearer to each
/// other than 0.82 diameters, until their packing fraction is 0.62: as dense as the packed wall, without
/// order.
inline void appendRandomPacking(AgentStore& agents, std::array<double, 3> side, double radius) {
  const double volume = side[0] * side[1] * side[2];
  const auto wanted =
      static_cast<Index>(0.62 * volume / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3)));
  RandomStream random(1, 0, 0, RandomPurpose::packing);
  const double nearest = 0.82 * 2 * radius;
  for (long tries = 0; agents.size() < wanted && tries < 3000000; ++tries) {
    const Vec3 centre(side[0] * random.uniform(), side[1] * random.uniform(), side[2] * random.uniform());
    bool isFree = true;
    for (Index j = 0; j < agents.size() && isFree; ++j) {
      isFree = (agents.position(j) - centre).squaredNorm() >= nearest * nearest;
    }
    if (isFree) agents.set(agents.append(AgentKind::smc, centre, radius), synthetic, true);
  }
}

}  // namespace restenosis::support
