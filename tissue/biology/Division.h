#pragma once

#include <cstdint>
#include <span>

#include "AgentStore.h"
#include "BondTable.h"

namespace restenosis {

/// Division of a cell into mother and daughter, each with the radius the mother was born with (model 5).
///
/// Their centres lie at +-`displacement` times that radius from the mother's, in opposite directions drawn
/// uniformly on the sphere by (seed, mother's id, generation). Both start in G0, with the mother's clock
/// (what the step left over) and one generation on; the daughter inherits the flags `synthetic` and
/// `covered`, the WSS, nitric oxide and stress last known of the mother, and is flagged `daughter`. Whatever
/// bonds the mother has she keeps, with their rest lengths; the daughter has none, so that the wall's bonds
/// stay those of the packed wall.
class Division {
 public:
  Division(std::uint64_t seed, double displacement) : seed_(seed), displacement_(displacement) {}

  /// Divides the cells `mothers`, which are in ascending order of their ids: daughters are appended and get
  /// their ids in that order, so that neither threads nor the order of agents can change who is who.
  void divide(AgentStore& agents, BondTable& bonds, std::span<const Index> mothers) const;

 private:
  std::uint64_t seed_;
  double displacement_;
};

}  // namespace restenosis
