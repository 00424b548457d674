#include "tissue/biology/Division.h"

#include "tissue/agents/RandomStream.h"

namespace restenosis {

AgentId daughterId(AgentId mother, std::uint32_t generation) {
  // The finaliser of SplitMix64 (Steele et al. 2014).
  std::uint64_t mixed = mother + 0x9e3779b97f4a7c15u * (std::uint64_t{generation} + 1);
  mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
  mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
  mixed ^= mixed >> 31;
  constexpr std::uint64_t bornBit = std::uint64_t{1} << 62, fits = bornBit - 1;
  return (mixed & fits) | bornBit;
}

void Division::divide(AgentStore& agents, BondTable& bonds, std::span<const Index> mothers) const {
  for (const Index mother : mothers) {
    RandomStream random(seed_, agents.id[mother], agents.generation[mother],
                        RandomPurpose::divisionDirection);
    const double radius = agents.birthRadius[mother];
    const float matrix = agents.matrix[mother] / 2;
    agents.setCell(mother, radius, matrix);
    const Vec3 offset = displacement_ * agents.radius[mother] * random.direction();
    const Vec3 centre = agents.position(mother);

    agents.setPosition(mother, centre + offset);
    agents.state[mother] = CycleState::g0;
    agents.g1Duration[mother] = 0;
    ++agents.generation[mother];

    const Index born = agents.append(AgentKind::smc, centre - offset, radius);
    agents.id[born] = daughterId(agents.id[mother], agents.generation[mother]);
    agents.set(born, synthetic, agents.has(mother, synthetic));
    agents.set(born, covered, agents.has(mother, covered));
    agents.set(born, daughter, true);
    agents.clock[born] = agents.clock[mother];
    agents.generation[born] = agents.generation[mother];
    agents.wss[born] = agents.wss[mother];
    agents.nitricOxide[born] = agents.nitricOxide[mother];
    agents.stress[born] = agents.stress[mother];
    agents.setCell(born, radius, matrix);
    if (agents.activation.modelled()) agents.activation.set(born, agents.activation[mother]);
    if (agents.maturity.modelled()) agents.maturity.set(born, agents.maturity[mother]);
  }
  bonds.resize(agents.size());
}

}  // namespace restenosis
