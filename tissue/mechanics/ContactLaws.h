#pragma once

#include <string_view>
#include <vector>

#include "ForceField.h"

namespace restenosis {

/// All that the force loop reads besides the agents.
struct ForceInput {
  const PairTable& pairs;
  const MechanicsParameters& parameters;
};

/// One contact law in the table: the force loop compiled for it, so that no pair pays for the choice.
struct ContactLaw {
  /// Sets loads[k] for the k-th agent of `subset`, which is ascending; in the calling thread.
  template <class Spheres>
  using Loop = void (*)(const ForceInput&, const Spheres&, std::span<const Index> subset,
                        std::span<AgentLoad> loads);

  std::string_view name;
  Loop<FixedSpheres> evaluateMixed;
  Loop<ExactSpheres> evaluateExact;
  double (*energy)(double modulus, double overlap, double reducedRadius);
  double (*validOverlap)(double reducedRadius);
};

/// The law called `name`. Throws std::invalid_argument naming the known ones.
const ContactLaw& contactLaw(std::string_view name);
std::vector<std::string_view> contactLawNames();

}  // namespace restenosis
