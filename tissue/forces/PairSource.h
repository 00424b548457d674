#pragma once

#include <limits>
#include <vector>

#include "tissue/agents/BondTable.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// A pair as seen from one of its agents.
struct Pair {
  Index partner;
  static constexpr float unbonded = std::numeric_limits<float>::infinity();

  /// Rest length of the bond [m], `unbonded` without one. Negative where the two cohere: one is a daughter.
  float restLength;
};

/// The pairs that may act on an agent: its neighbours and the partners of its bonds. What it refers to must
/// outlive it.
struct PairSource {
  const NeighbourList& neighbours;
  const BondTable& bonds;
  const std::vector<std::uint8_t>& flags;  ///< of the agents
  bool cohesion;                           ///< whether daughters cohere

  /// Fetches what append() reads of agent i. Speed only: some 5 % of a relaxation where pairs are listed.
  void prefetch(Index i) const {
    __builtin_prefetch(neighbours.of(i).data());
    __builtin_prefetch(bonds.of(i).data());
  }
  /// Appends the pairs of agent i in ascending order of partners, each once.
  void append(Index i, std::vector<Pair>& pairs) const;
};

}  // namespace restenosis
