#include "Division.h"

#include "RandomStream.h"

namespace restenosis {

void Division::divide(AgentStore& agents, BondTable& bonds, std::span<const Index> mothers) const {
  for (const Index mother : mothers) {
    RandomStream random(seed_, agents.id[mother], agents.generation[mother],
                        RandomPurpose::divisionDirection);
    const double radius = agents.birthRadius[mother];
    const Vec3 offset = displacement_ * radius * random.direction();
    const Vec3 centre = agents.position(mother);

    agents.setPosition(mother, centre + offset);
    agents.radius[mother] = radius;
    agents.state[mother] = CycleState::g0;
    agents.g1Duration[mother] = 0;
    ++agents.generation[mother];

    const Index born = agents.append(AgentKind::smc, centre - offset, radius);
    agents.set(born, synthetic, agents.has(mother, synthetic));
    agents.set(born, covered, agents.has(mother, covered));
    agents.set(born, daughter, true);
    agents.clock[born] = agents.clock[mother];
    agents.generation[born] = agents.generation[mother];
    agents.wss[born] = agents.wss[mother];
    agents.nitricOxide[born] = agents.nitricOxide[mother];
    agents.pressure[born] = agents.pressure[mother];
  }
  bonds.resize(agents.size());
}

}  // namespace restenosis
