#pragma once

#include <cmath>
#include <string_view>

#include "tests/support/Constants.h"
#include "tissue/agents/BondTable.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/forces/MechanicsParameters.h"

namespace restenosis::support {

/// A crowded heap with unequal radii, bonds between near agents and daughters, so that every force acts.
struct Heap {
  AgentStore agents;
  BondTable bonds;

  explicit Heap(int count = 200) {
    RandomStream random(9, 0, 0, RandomPurpose::packing);
    const double side = 1.8 * r * std::cbrt(count);
    for (int k = 0; k < count; ++k) {
      const Vec3 place = side * Vec3(random.uniform(), random.uniform(), random.uniform());
      const Index i = agents.append(AgentKind::smc, place, r * (0.7 + 0.6 * random.uniform()));
      agents.set(i, AgentFlag::daughter, k % 3 == 0);
    }
    bonds.resize(agents.size());
    for (Index i = 0; i < agents.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        const double distance = (agents.position(i) - agents.position(j)).norm();
        if (distance < 2.2 * r) bonds.connect(i, j, distance * (0.8 + 0.3 * random.uniform()));
      }
    }
  }
};

/// Forces by this contact law, with a cohesion that one notices.
inline MechanicsParameters ofLaw(std::string_view law) {
  MechanicsParameters p;
  p.contactLaw = law;
  p.cohesionModulus = 0.5e6;
  return p;
}

}  // namespace restenosis::support
