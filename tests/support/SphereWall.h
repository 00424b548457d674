#pragma once

#include <cmath>
#include <numbers>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {

/// A wall for tests: `layers` layers of touching spheres of radius r, the inner faces of the first at `lumen`
/// from the axis, each sphere moved at random by up to `noise` in every direction.
inline AgentStore sphereWall(double lumen, double length, double r, int layers = 2, double noise = 0,
                             std::uint64_t seed = 1) {
  AgentStore agents;
  const int planes = std::max(1, static_cast<int>(std::lround(length / (2 * r))));
  for (int layer = 0; layer < layers; ++layer) {
    const double radius = lumen + r * (1 + 2 * layer);
    const int around = static_cast<int>(std::numbers::pi * radius / r);
    for (int k = 0; k < planes; ++k)
      for (int n = 0; n < around; ++n) {
        const double angle = 2 * std::numbers::pi * (n + 0.5 * (k % 2)) / around;
        RandomStream random(seed, agents.nextId, 0, RandomPurpose::packing);
        auto shift = [&] { return noise * (2 * random.uniform() - 1); };
        const double dx = shift(), dy = shift(), dz = shift();
        agents.append(
            layer == 0 ? AgentKind::iel : AgentKind::smc,
            {radius * std::cos(angle) + dx, radius * std::sin(angle) + dy, (k + 0.5) * length / planes + dz},
            r);
      }
  }
  return agents;
}

}  // namespace restenosis
