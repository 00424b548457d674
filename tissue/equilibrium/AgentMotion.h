#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// What the others do to an agent.
struct AgentForce {
  Vec3 force = Vec3::Zero();  ///< what constraints leave of it [N]
  double stiffness = 0;       ///< sum of the slopes of its pair forces, never 0 once known [N/m]
  /// How far the force would still move it: force over stiffness, over its radius.
  double residual = 0;
};

/// An agent of the store as one that is about to move.
struct AgentMotion {
  Vec3 position = Vec3::Zero();  ///< [m]
  double radius = 0;             ///< [m]
  float leash = 0;               ///< at least so far it may go before the neighbour list is looked at [m]
  float room = 0;  ///< at least so far it may go before a constraint acts (Constraint::room) [m]
  AgentKind kind = AgentKind::smc;
  bool daughter = false;
};

}  // namespace restenosis
