#pragma once

#include <span>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Where agents are, how large and of which kind: all that a search for neighbours reads, be it of the agents
/// themselves or of a copy of their shapes. Holds only as long as what it was made of does not change.
struct AgentShapes {
  std::span<const double> x, y, z;  ///< centre [m]
  std::span<const double> radius;   ///< [m]
  std::span<const AgentKind> kind;

  static AgentShapes of(const AgentStore& agents) {
    return {agents.x, agents.y, agents.z, agents.radius, agents.kind};
  }
  Index size() const { return static_cast<Index>(x.size()); }
  Vec3 position(Index i) const { return {x[i], y[i], z[i]}; }
};

}  // namespace restenosis
