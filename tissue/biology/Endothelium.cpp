#include "tissue/biology/Endothelium.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {

Endothelium::Endothelium(const EndotheliumParameters& parameters, std::uint64_t seed, bool denuded)
    : scenario_(endotheliumScenario(parameters.scenario)),
      seed_(seed),
      denuded_(denuded),
      maturationTime_(parameters.maturationTime) {}

double Endothelium::target(double time) const { return denuded_ ? scenario_.coverage(time) : 1.0; }

double Endothelium::onset() const { return denuded_ ? scenario_.onset() : 0.0; }

double Endothelium::completion() const { return denuded_ ? scenario_.completion() : 0.0; }

void Endothelium::begin(AgentStore& agents) const {
  if (!agents.maturity.modelled()) return;
  for (Index i = 0; i < agents.size(); ++i) agents.maturity.set(i, agents.has(i, covered) ? 1 : 0);
}

void Endothelium::mature(AgentStore& agents, double duration) const {
  if (!agents.maturity.modelled()) return;
  const auto left = static_cast<float>(std::exp(-duration / maturationTime_));
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    if (agents.has(i, covered)) agents.maturity.set(i, 1 - (1 - agents.maturity[i]) * left);
  });
}

CoverageReport Endothelium::apply(AgentStore& agents, double time) const {
  struct Bare {
    double u;
    AgentId id;
    Index index;
  };
  CoverageReport report;
  std::vector<Bare> bare;
  for (const Index i : agentsThat(agents.size(), [&](Index i) {
         return agents.kind[i] == AgentKind::smc && agents.has(i, exposed) && agents.has(i, synthetic);
       })) {
    ++report.exposed;
    if (agents.has(i, covered)) {
      ++report.covered;
    } else {
      bare.push_back({0, agents.id[i], i});
    }
  }
  const auto wanted = static_cast<Index>(std::lround(target(time) * report.exposed));
  if (wanted <= report.covered) return report;
  report.newlyCovered = wanted - report.covered;

  for (Bare& b : bare) b.u = RandomStream(seed_, b.id, 0, RandomPurpose::endotheliumSeeding).uniform();
  const auto last = bare.begin() + report.newlyCovered;
  const auto before = [](const Bare& a, const Bare& b) {
    return std::pair(a.u, a.id) < std::pair(b.u, b.id);
  };
  if (last != bare.end()) std::nth_element(bare.begin(), last, bare.end(), before);
  std::for_each(bare.begin(), last, [&](const Bare& b) {
    agents.set(b.index, covered, true);
    if (agents.maturity.modelled()) agents.maturity.set(b.index, denuded_ ? 0 : 1);
  });
  report.covered = wanted;
  return report;
}

}  // namespace restenosis
