#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/forces/PairSource.h"

namespace restenosis {

/// The pairs of up to `most` agents as the force loop reads them, one line after the other: agents stand
/// side by side in groups, and each line holds the next pair of every agent of a group. In a group are agents
/// with rows of like length and of one kind, for the group is as long as the longest of them, and all of it
/// computes what one of them needs. Speed only: a row keeps the order of its partners.
class PairRows {
 public:
  static constexpr std::size_t most = 256;
  static constexpr std::size_t width = 16;  ///< agents of a group

  /// What the pairs of an agent are, or those of a group at most.
  enum class Kind : std::uint8_t {
    unmarked,  ///< none is marked
    mixed,     ///< some may be
    marked     ///< all are, and none has a bond: those of daughters, most of which have none
  };
  struct alignas(64) Partners {
    std::array<Index, width> agent;  ///< beyond the end of an agent's row: nobody
  };
  struct alignas(64) Rests {
    std::array<float, width> length;  ///< as ActingPair::rest
  };

  /// Lays out the rows of these agents. `nobody`: an index that no agent has, a sphere that touches nothing.
  void layOut(const PairSource& source, std::span<const Index> agents, Index nobody);
  /// Lays out anew the row of the k-th of them, which is agent i; where there is no room for it, nothing is
  /// done and false returned.
  bool replace(const PairSource& source, std::size_t k, Index i);

  std::size_t groups() const { return (size_ + width - 1) / width; }
  std::span<const Partners> partners(std::size_t group) const {
    return std::span(partners_).subspan(groups_[group].start, groups_[group].length);
  }
  /// Of the same lines; nothing for a group of marked pairs, none of which has a bond.
  std::span<const Rests> rests(std::size_t group) const {
    if (kind(group) == Kind::marked) return {};
    return std::span(rests_).subspan(groups_[group].restStart, groups_[group].length);
  }
  Kind kind(std::size_t group) const { return groups_[group].kind; }
  std::size_t size() const { return size_; }
  /// Which of the agents is the n-th in the order of the groups.
  std::size_t operator[](std::size_t n) const { return order_[n]; }
  std::size_t bytes() const { return partners_.size() * sizeof(Partners) + rests_.size() * sizeof(Rests); }

 private:
  struct Group {
    std::uint32_t start = 0, restStart = 0, length = 0, room = 0;
    Kind kind = Kind::unmarked;
  };
  /// Fills the lines of one agent.
  void put(const Group& group, std::size_t lane, std::span<const ActingPair> row);
  void put(const Group& group, std::size_t lane, std::span<const Index> markedRow);

  std::vector<Partners> partners_;
  std::vector<Rests> rests_;
  std::array<Group, most / width> groups_;
  std::array<std::uint8_t, most> order_{};
  std::size_t size_ = 0;
  Index nobody_ = 0;
};

}  // namespace restenosis
