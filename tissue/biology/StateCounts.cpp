#include "StateCounts.h"

namespace restenosis {

StateCounts countStates(const AgentStore& agents) {
  StateCounts counts;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != AgentKind::smc) continue;
    ++counts.smc;
    switch (agents.state[i]) {
      case CycleState::g0:
        ++counts.g0;
        break;
      case CycleState::g1:
        ++counts.g1;
        break;
      case CycleState::sg2m:
        ++counts.sg2m;
        break;
    }
    const bool isExposedSynthetic = agents.has(i, exposed) && agents.has(i, synthetic);
    counts.synthetic += agents.has(i, synthetic);
    counts.inhibited += agents.has(i, inhibited);
    counts.exposed += agents.has(i, exposed);
    counts.covered += agents.has(i, covered);
    counts.exposedSynthetic += isExposedSynthetic;
    counts.coveredExposed += isExposedSynthetic && agents.has(i, covered);
    counts.daughters += agents.has(i, daughter);
  }
  return counts;
}

}  // namespace restenosis
