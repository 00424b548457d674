#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "AgentStore.h"

namespace restenosis {

/// One end of a bond: the agent at the other end and the distance of centres at which it carries no load.
struct Bond {
  Index partner;
  float restLength;  ///< [m]
};

/// Bonds between agents, at most twelve an agent (ISR3D). Every bond is stored at both of its ends, and an
/// agent's bonds are sorted by partner, so that sums over them have one order. Those without bonds, as the
/// daughters of a growing wall, take next to no memory.
class BondTable {
 public:
  static constexpr std::size_t maxBonds = 12;

  std::span<const Bond> of(Index agent) const {
    const Row row = rows_[agent];
    return {bonds_.data() + row.start, row.count};
  }
  Index size() const { return static_cast<Index>(rows_.size()); }
  std::size_t bondCount() const;

  /// Makes room for `agents` agents; new ones have no bonds.
  void resize(Index agents);
  bool bonded(Index a, Index b) const;
  /// Bonds a and b unless they are bonded or either has no room left; tells whether it did.
  bool connect(Index a, Index b, double restLength);
  void disconnect(Index a, Index b);
  void disconnectAll(Index agent);
  /// Follows AgentStore::reorder and AgentStore::erase.
  void reorder(std::span<const Index> order);
  void erase(std::span<const std::uint8_t> remove);

  template <class Archive>
  void archive(Archive& a) {
    a(bonds_, rows_);
  }

 private:
  /// Where an agent's bonds are in bonds_, and for how many there is room.
  struct Row {
    std::uint32_t start = 0;
    std::uint16_t count = 0, room = 0;
  };
  void insert(Index agent, Bond bond);
  void remove(Index agent, Index partner);
  /// Gives a row more room, at the end of bonds_.
  void widen(Row& row);
  /// Moves the rows together: afterwards agent k has the bonds of agent rowOf(k), whose partners are called
  /// nameOf(partner) now.
  template <class RowOf, class NameOf>
  void layOut(Index agents, RowOf&& rowOf, NameOf&& nameOf);

  std::vector<Bond> bonds_;
  std::vector<Row> rows_;
  std::size_t abandoned_ = 0;  ///< places of bonds_ that no row has any more; speed and memory only
};

}  // namespace restenosis
