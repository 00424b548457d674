#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Numbers of SMC by state; all but the first are subsets of `smc`.
struct StateCounts {
  Index smc = 0;
  Index g0 = 0, g1 = 0, sg2m = 0;  ///< by phase of the cycle
  Index synthetic = 0;
  Index inhibited = 0;
  Index exposed = 0;
  Index covered = 0;
  Index coveredExposed = 0;  ///< exposed and synthetic as well: over `exposedSynthetic` it is the coverage
  Index exposedSynthetic = 0;
  Index daughters = 0;  ///< born during growth

  /// Share of the exposed synthetic cells that carry endothelium; 0 where there are none.
  double coverage() const {
    return exposedSynthetic > 0 ? static_cast<double>(coveredExposed) / exposedSynthetic : 0.0;
  }
  void join(const StateCounts& other);
};

StateCounts countStates(const AgentStore& agents);

}  // namespace restenosis
