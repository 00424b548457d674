#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// The sum of the pair forces on one agent.
///
/// The virial stress of an agent has half of each pair's branch vector b (from centre to centre):
/// sigma = -(1/V) sum 1/2 b (x) F with F the force on the agent and b pointing to it; stress =
/// -tr(sigma)/3.
struct AgentLoad {
  double fx = 0, fy = 0, fz = 0;  ///< [N]
  double stress = 0;     ///< minus a third of the trace of the virial stress [Pa]; compression positive
  double stiffness = 0;  ///< sum of the slopes of the acting pair forces [N/m]

  Vec3 force() const { return {fx, fy, fz}; }
};

}  // namespace restenosis
