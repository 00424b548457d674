#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/forces/AgentLoad.h"
#include "tissue/forces/BondAttraction.h"
#include "tissue/forces/Cohesion.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/forces/OneContact.h"
#include "tissue/forces/PairSource.h"

namespace restenosis {

/// The load of agent i with these pairs: the reference of PairKernel, in double precision and one pair
/// after the other.
template <class Law>
AgentLoad plainLoad(const MechanicsParameters& p, const AgentStore& agents, Index i,
                    std::span<const Pair> pairs) {
  const Law law(p.contactModulus);
  const Cohesion cohesion{p.cohesionModulus, p.cohesionRange};
  const BondAttraction attraction{p.bondModulus, p.bondAxialFactor};
  const double r = agents.radius[i];
  AgentLoad load;
  double virial = 0;
  for (const auto& [j, restLength] : pairs) {
    const Vec3 branch = agents.position(i) - agents.position(j);
    const double radii = r + agents.radius[j], rest = std::abs(restLength);
    double distance = branch.norm();
    Vec3 direction = branch / distance;
    if (distance == 0) direction = Vec3::Constant(i < j ? 1 : -1) / std::numbers::sqrt3;

    double push = 0;  // along `direction` [N]
    if (distance < radii) {
      const double reduced = r * agents.radius[j] / radii;
      push += forceOf(law, radii - distance, reduced);
      load.stiffness += stiffnessOf(law, radii - distance, reduced);
    }
    if (distance > rest) {
      const double cosine2 = direction.z() * direction.z();
      push -= attraction.pull(distance, rest, radii, cosine2);
      load.stiffness += attraction.stiffness(rest, radii, cosine2);
    }
    const double attracted = restLength < 0 ? cohesion.pull(distance - radii, radii) : 0;
    if (attracted > 0) load.stiffness += cohesion.stiffness(radii);
    push -= attracted;

    load.fx += push * direction.x(), load.fy += push * direction.y(), load.fz += push * direction.z();
    virial += push * distance;
  }
  load.stress = virial / (8 * std::numbers::pi * r * r * r);  // 2 (halves) x 3 (trace) x V
  return load;
}

}  // namespace restenosis
