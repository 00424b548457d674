#pragma once

#include "AgentStore.h"

namespace restenosis {

/// What the others do to an agent.
struct AgentForce {
  Vec3 force = Vec3::Zero();  ///< what constraints leave of it [N]
  double stiffness = 0;       ///< sum of the slopes of its pair forces, never 0 once known [N/m]
  /// The force, for a daughter times `firm` over the stiffness of her contacts, taken as `softest` at least,
  /// where that is above 1 (AgentForces::Settings) [N].
  double restlessness = 0;
};

/// An agent that moves, with all of its own that a step reads and writes side by side: those that are awake
/// among sleepers are few, and far apart in the store.
struct AgentMotion {
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< the minimiser's own; zero for an agent that has just become active
  AgentForce now;                ///< where it is
  double radius = 0;             ///< [m]
  float leash = 0;               ///< at least so far it may go before the neighbour list is looked at [m]
  float way = 0;                 ///< it has come since those beside it were looked at [m]
  AgentKind kind = AgentKind::smc;
  bool daughter = false;
};

}  // namespace restenosis
