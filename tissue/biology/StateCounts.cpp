#include "tissue/biology/StateCounts.h"

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

void count(const AgentStore& agents, Index i, StateCounts& counts) {
  if (agents.kind[i] != AgentKind::smc) return;
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

}  // namespace

void StateCounts::join(const StateCounts& other) {
  smc += other.smc;
  g0 += other.g0, g1 += other.g1, sg2m += other.sg2m;
  synthetic += other.synthetic, inhibited += other.inhibited;
  exposed += other.exposed, covered += other.covered;
  coveredExposed += other.coveredExposed, exposedSynthetic += other.exposedSynthetic;
  daughters += other.daughters;
}

StateCounts countStates(const AgentStore& agents) {
  return reduceInChunks<StateCounts>(
      agents.size(), [&](std::size_t i, StateCounts& part) { count(agents, static_cast<Index>(i), part); });
}

}  // namespace restenosis
