#pragma once

#include "AgentStore.h"

namespace restenosis {

/// What moves one agent, a cache line: an agent that is awake among sleepers brings all of it at once.
struct alignas(64) AgentMotion {
  Vec3 force = Vec3::Zero();     ///< what constraints leave of it [N]
  double stiffness = 0;          ///< sum of the slopes of its pair forces, never 0 once known [N/m]
  Vec3 velocity = Vec3::Zero();  ///< the minimiser's own; zero for an agent that has just become active
  double restlessness = 0;       ///< AgentForces::restlessness; 0 for agents that are not free [N]
};

}  // namespace restenosis
