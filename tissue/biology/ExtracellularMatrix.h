#pragma once

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/ExtracellularMatrixParameters.h"

namespace restenosis {

/// Matrix around cells (model 5). An agent is a cell and the matrix that it has laid down around itself, so
/// there are no more agents for it: R^3 = R_cell^3 + R_matrix^3. A free synthetic cell that contact
/// inhibition does not hold adds `rate` times its activation (1 where activation is not modelled) of its
/// volume at birth, until matrix is `largestShare` of the agent.
class ExtracellularMatrix {
 public:
  explicit ExtracellularMatrix(const ExtracellularMatrixParameters& parameters) : p_(parameters) {}

  /// Lets cells lay down matrix for `duration` [s] at their present activation. Returns whether any did.
  bool deposit(AgentStore& agents, double duration) const;

 private:
  ExtracellularMatrixParameters p_;
};

}  // namespace restenosis
