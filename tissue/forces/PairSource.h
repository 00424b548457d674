#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/BondTable.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// One of those that act on an agent.
struct ActingPair {
  Index partner;
  /// Rest length of the bond [m], infinite where there is none. Negative where either of the pair is a
  /// daughter and these are marked.
  float rest;
};

/// Who acts on whom: neighbours and partners of bonds. What it refers to must outlive it.
struct PairSource {
  const NeighbourList& neighbours;
  const BondTable& bonds;
  const std::vector<std::uint8_t>& flags;  ///< of the agents
  bool marksDaughters;                     ///< whether pairs with a daughter are marked

  /// Whether all pairs of agent i are marked and none has a bond: its partners are its neighbours.
  bool allMarked(Index i) const {
    return marksDaughters && (flags[i] & AgentFlag::daughter) && bonds.of(i).empty();
  }
  /// Brings into the cache what append() reads of these agents. Speed only.
  void readAhead(std::span<const Index> agents) const {
    neighbours.readAhead(agents);
    bonds.readAhead(agents);
  }
  /// Appends the partners of agent i in ascending order, each once; returns whether any pair is marked.
  bool append(Index i, std::vector<ActingPair>& pairs) const;
};

}  // namespace restenosis
