#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// An agent near a cell.
struct ContactNeighbour {
  Vec3 offset;      ///< from the cell's centre to the neighbour's [m]
  double distance;  ///< length of `offset` [m]
  double radius;    ///< [m]
  AgentKind kind;
  /// Cosine between `offset` and the normal of the lamina the neighbour is part of, 0 to 1; 1 if it is of
  /// none.
  double facing = 1;
};

}  // namespace restenosis
