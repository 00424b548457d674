#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/JaggedArray.h"

namespace restenosis {

/// One end of a bond: the agent at the other end and the distance of centres at which it carries no load.
struct Bond {
  Index partner;
  float restLength;  ///< [m]
};

/// Bonds between agents, at most twelve an agent (ISR3D). Every bond is stored at both of its ends, and an
/// agent's bonds are sorted by partner, so that sums over them have one order. Those without bonds, as the
/// daughters of a growing wall, need next to no memory.
class BondTable {
 public:
  static constexpr std::size_t maxBonds = 12;

  std::span<const Bond> of(Index agent) const { return lists_[agent]; }
  Index size() const { return static_cast<Index>(lists_.size()); }
  std::size_t bondCount() const { return lists_.elementCount() / 2; }

  /// Makes it the table of `agents` agents; new ones have no bonds.
  void resize(Index agents) { lists_.resize(agents); }
  /// Reserves memory for moreOf(i) more bonds of agent i, so that making them moves no list. Speed only.
  template <class MoreOf>
  void reserveMore(const MoreOf& moreOf) {
    lists_.spread([&](std::size_t i) { return moreOf(static_cast<Index>(i)); });
  }
  bool bonded(Index a, Index b) const;
  /// Bonds a and b unless they are bonded or either has as many as it may; tells whether it did.
  bool connect(Index a, Index b, double restLength);
  void disconnect(Index a, Index b);
  void disconnectAll(Index agent);
  /// Follows AgentStore::reorder and AgentStore::erase.
  void reorder(std::span<const Index> order);
  void erase(std::span<const std::uint8_t> remove);

  template <class Archive>
  void archive(Archive& a) {
    a(lists_);
  }

 private:
  void insert(Index agent, Bond bond);
  void remove(Index agent, Index partner);
  /// Afterwards agent k has the bonds of agent agents[k], their partners with the index newIndex[partner].
  void select(std::span<const Index> agents, std::span<const Index> newIndex);

  JaggedArray<Bond> lists_;
};

}  // namespace restenosis
