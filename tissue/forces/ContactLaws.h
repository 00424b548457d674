#pragma once

#include <string_view>
#include <vector>

#include "tissue/forces/ForceField.h"

namespace restenosis {

/// One contact law in the table: the pair kernels compiled for it, so that no pair pays for the choice.
struct ContactLaw {
  /// Sets loads[k] for the k-th of `agents`, which have the pairs `list`; in the calling thread.
  template <class Spheres>
  using Kernel = void (*)(const MechanicsParameters&, const Spheres&, const PairList& list,
                          std::span<const Index> agents, std::span<AgentLoad> loads);

  std::string_view name;
  Kernel<FixedSpheres> evaluateMixed;
  Kernel<ExactSpheres> evaluateExact;
  /// PlainPairKernel
  AgentLoad (*plainLoad)(const MechanicsParameters&, const AgentStore&, Index i, std::span<const Pair>);
  double (*energy)(double modulus, double overlap, double reducedRadius);
  double (*validOverlap)(double reducedRadius);  ///< in proportion to it, or infinite
};

/// The law called `name`. Throws std::invalid_argument naming the known ones.
const ContactLaw& contactLaw(std::string_view name);
std::vector<std::string_view> contactLawNames();

}  // namespace restenosis
