#include "bridge/coupling/StressReaders.h"

namespace restenosis {

bool readsStress(const AgentStore& agents, Index agent) {
  return agents.kind[agent] == AgentKind::smc && agents.has(agent, AgentFlag::covered) &&
         agents.has(agent, AgentFlag::synthetic) && !agents.has(agent, AgentFlag::fixed) &&
         !agents.has(agent, AgentFlag::inhibited) && agents.state[agent] != CycleState::sg2m;
}

std::vector<Index> undecidedCells(const AgentStore& agents, double arrestingWss, double margin) {
  std::vector<Index> cells;
  for (Index i = 0; i < agents.size(); ++i)
    if (readsStress(agents, i) && agents.wss[i] < margin * arrestingWss) cells.push_back(i);
  return cells;
}

}  // namespace restenosis
