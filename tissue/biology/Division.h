#pragma once

#include <cstdint>
#include <span>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"

namespace restenosis {

/// Id of a daughter, from the mother's id and generation after the division. A cell's id, and with it every
/// random number it draws, thus depends on its pedigree and not on how many cells were born before it: two
/// runs that differ in one cell's fate share all other draws. 62 bits of a hash, with a bit set that counted
/// ids never reach; among a million births two share an id with a probability of 1e-7.
AgentId daughterId(AgentId mother, std::uint32_t generation);

/// Division of a cell into mother and daughter, each with the radius the mother was born with (model 5).
///
/// Each keeps half of the mother's matrix. Their centres lie at +-`displacement` times their radius, matrix
/// included, from the mother's, in opposite directions drawn
/// uniformly on the sphere by (seed, mother's id, generation). Both start in G0, with the mother's clock
/// (what the step left over) and one generation on; the daughter inherits the flags `synthetic` and
/// `covered` and the WSS, nitric oxide, stress, activation and maturity of endothelium of the mother, and is
/// flagged `daughter`. The mother keeps its bonds and their rest lengths; the daughter has none (see
/// bondDaughters).
class Division {
 public:
  Division(std::uint64_t seed, double displacement) : seed_(seed), displacement_(displacement) {}

  /// Divides the cells `mothers`, in ascending order of their ids. Daughters are appended in that order, so
  /// their order does not depend on threads or on the order of agents.
  void divide(AgentStore& agents, BondTable& bonds, std::span<const Index> mothers) const;

 private:
  std::uint64_t seed_;
  double displacement_;
};

}  // namespace restenosis
