#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "PairSource.h"

namespace restenosis {

/// The pairs of up to `most` agents as the force loop reads them, one line after the other: agents stand
/// side by side in groups, and each line holds the next pair of every agent of a group. In a group are agents
/// with rows of like length, those with marked pairs apart from the others, for the group is as long as the
/// longest of them, and all of it computes cohesion where one does. Speed only: a row keeps the order of its
/// partners.
class PairRows {
 public:
  static constexpr std::size_t most = 256;
  static constexpr std::size_t width = 16;  ///< agents of a group

  struct alignas(64) Line {
    std::array<Index, width> partner;  ///< beyond the end of an agent's row: nobody
    std::array<float, width> rest;     ///< as ActingPair::rest
  };

  /// Lays out the rows of these agents. `nobody`: an index that no agent has, a sphere that touches nothing.
  void layOut(const PairSource& source, std::span<const Index> agents, Index nobody);
  /// Lays out anew the row of the k-th of them, which is agent i; where there is no room for it, nothing is
  /// done and false returned.
  bool replace(const PairSource& source, std::size_t k, Index i);

  std::size_t groups() const { return (size_ + width - 1) / width; }
  std::span<const Line> lines(std::size_t group) const {
    return std::span(lines_).subspan(groups_[group].start, groups_[group].length);
  }
  /// False if no pair in the group is marked.
  bool marked(std::size_t group) const { return groups_[group].marked; }
  std::size_t size() const { return size_; }
  /// Which of the agents is the n-th in the order of the groups.
  std::size_t operator[](std::size_t n) const { return order_[n]; }
  std::size_t bytes() const { return lines_.size() * sizeof(Line); }

 private:
  struct Group {
    std::uint32_t start = 0, length = 0, room = 0;
    bool marked = false;
  };
  /// Fills the lines of one agent.
  void put(const Group& group, std::size_t lane, std::span<const ActingPair> row);

  std::vector<Line> lines_;
  std::array<Group, most / width> groups_;
  std::array<std::uint8_t, most> order_{};
  std::size_t size_ = 0;
  Index nobody_ = 0;
};

}  // namespace restenosis
