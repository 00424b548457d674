#pragma once

#include <cstdint>
#include <span>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"

namespace restenosis {

/// Name of the daughter that a mother gives birth to, from the mother's name and her generation after the
/// division. A cell's name, and with it every random number it draws, thus follows from its pedigree and not
/// from how many cells were born before it elsewhere: two runs that differ in one cell's fate share all other
/// draws. 62 bits of a hash, with a bit set that founders' counted ids never reach; among a million births
/// two share a name with a probability of 1e-7.
AgentId daughterId(AgentId mother, std::uint32_t generation);

/// Division of a cell into mother and daughter, each with the radius the mother was born with (model 5).
///
/// Their centres lie at +-`displacement` times that radius from the mother's, in opposite directions drawn
/// uniformly on the sphere by (seed, mother's id, generation). Both start in G0, with the mother's clock
/// (what the step left over) and one generation on; the daughter inherits the flags `synthetic` and
/// `covered`, the WSS, nitric oxide and stress last known of the mother, and is flagged `daughter`. Whatever
/// bonds the mother has she keeps, with their rest lengths; the daughter has none (see bondDaughters).
class Division {
 public:
  Division(std::uint64_t seed, double displacement) : seed_(seed), displacement_(displacement) {}

  /// Divides the cells `mothers`, which are in ascending order of their ids: daughters are appended in that
  /// order, so that neither threads nor the order of agents can change it.
  void divide(AgentStore& agents, BondTable& bonds, std::span<const Index> mothers) const;

 private:
  std::uint64_t seed_;
  double displacement_;
};

}  // namespace restenosis
