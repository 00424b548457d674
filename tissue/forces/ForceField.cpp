#include "tissue/forces/ForceField.h"

#include <algorithm>

#include "tissue/agents/Chunks.h"
#include "tissue/forces/BondAttraction.h"
#include "tissue/forces/Cohesion.h"
#include "tissue/forces/ContactLaws.h"

namespace restenosis {

ForceField::ForceField(const MechanicsParameters& parameters)
    : parameters_(parameters), law_(&contactLaw(parameters.contactLaw)) {}

NeighbourRange ForceField::range(double skin) const {
  return {.factor = 1,
          .daughterFactor = parameters_.cohesionModulus > 0 ? parameters_.cohesionRange : 1,
          .skin = skin};
}

PairSource ForceField::pairs(const AgentStore& agents, const NeighbourList& neighbours,
                             const BondTable& bonds) const {
  return {neighbours, bonds, agents.flags, parameters_.cohesionModulus > 0};
}

void ForceField::evaluate(const ExactSpheres& spheres, const PairList& list, std::span<const Index> agents,
                          std::span<AgentLoad> loads) const {
  law_->evaluateExact(parameters_, spheres, list, agents, loads);
}

void ForceField::evaluate(const FixedSpheres& spheres, const PairList& list, std::span<const Index> agents,
                          std::span<AgentLoad> loads) const {
  law_->evaluateMixed(parameters_, spheres, list, agents, loads);
}

std::vector<AgentLoad> ForceField::evaluate(const AgentStore& agents, const BondTable& bonds) const {
  NeighbourList neighbours;
  neighbours.build(agents, range(0));
  const PairSource source = pairs(agents, neighbours, bonds);
  std::vector<AgentLoad> loads(agents.size());
  forEachChunk(agents.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Pair> ofAgent;
    for (std::size_t k = begin; k < end; ++k) {
      const auto i = static_cast<Index>(k);
      ofAgent.clear();
      source.append(i, ofAgent);
      loads[k] = law_->plainLoad(parameters_, agents, i, ofAgent);
    }
  });
  return loads;
}

void ForceField::setStresses(AgentStore& agents, const BondTable& bonds) const {
  const std::vector<AgentLoad> loads = evaluate(agents, bonds);
  for (Index i = 0; i < agents.size(); ++i)
    if (agents.kind[i] != AgentKind::strut) agents.stress[i] = loads[i].stress;
}

double ForceField::energy(const AgentStore& agents, const BondTable& bonds) const {
  NeighbourList neighbours;
  neighbours.build(agents, range(0));
  const Cohesion cohesion{parameters_.cohesionModulus, parameters_.cohesionRange};
  const BondAttraction attraction{parameters_.bondModulus, parameters_.bondAxialFactor};
  double total = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    const bool daughter = agents.has(i, AgentFlag::daughter);
    for (const Index j : neighbours.of(i)) {
      if (j < i) continue;
      const double radii = agents.radius[i] + agents.radius[j];
      const double gap = (agents.position(i) - agents.position(j)).norm() - radii;
      if (gap < 0)
        total += law_->energy(parameters_.contactModulus, -gap, agents.radius[i] * agents.radius[j] / radii);
      if (daughter || agents.has(j, AgentFlag::daughter)) total += cohesion.energy(gap, radii);
    }
    for (const Bond& bond : bonds.of(i)) {
      if (bond.partner < i) continue;
      const double distance = (agents.position(i) - agents.position(bond.partner)).norm();
      total += attraction.energy(distance, bond.restLength, agents.radius[i] + agents.radius[bond.partner]);
    }
  }
  return total;
}

Index ForceField::agentsBeyondLaw(const AgentStore& agents) const {
  if (agents.size() == 0) return 0;
  // Those most unlike in size may come nearest, in shares of R1 + R2, before the law ends
  const auto [least, most] = std::ranges::minmax(agents.radius);
  const double nearest = 1 - law_->validOverlap(least * most / (least + most)) / (least + most);
  if (!(nearest > 0)) return 0;
  NeighbourList neighbours;
  neighbours.build(agents, {.factor = nearest, .daughterFactor = nearest, .skin = 0});
  const auto isBeyond = [&](Index i, Index j) {
    const double radii = agents.radius[i] + agents.radius[j];
    const double overlap = radii - (agents.position(i) - agents.position(j)).norm();
    return overlap > law_->validOverlap(agents.radius[i] * agents.radius[j] / radii);
  };
  Index count = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    count += agents.kind[i] != AgentKind::strut &&
             std::ranges::any_of(neighbours.of(i), [&](Index j) { return isBeyond(i, j); });
  }
  return count;
}

}  // namespace restenosis
