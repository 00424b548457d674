#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "BondTable.h"
#include "Lanes.h"
#include "NeighbourList.h"

namespace restenosis {

/// Who acts on whom, laid out for computing the agents of a group, laneCount that follow each other in the
/// store, at once: for each of them its neighbours and bond partners in ascending order, each once, and with
/// each the rest length of the bond. Agents next to each other in the store should be so in space
/// (spatialOrder); this decides speed, no result.
class PairTable {
 public:
  /// The k-th partner of each agent of a group. Rows that are shorter than the longest of their group end in
  /// nobody().
  struct alignas(64) Block {
    std::array<Index, laneCount> partner;
    /// Rest length of the bond [m], infinite where there is none. Negative where either of the pair is a
    /// daughter.
    std::array<float, laneCount> rest;
  };

  /// `flags`: of the agents. `daughters`: whether pairs with a daughter are to be marked. All three have the
  /// same number of agents.
  void build(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
             bool daughters);
  /// The same where, since the last build or update, only the neighbours of the agents `changed`, in
  /// ascending order, did. Agents appended since are among these, and all fit below nobody().
  void update(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
              bool daughters, std::span<const Index> changed);

  Index size() const { return size_; }
  /// An index that no agent has; there is room for an eighth more agents below it than there were when the
  /// table was built.
  Index nobody() const { return nobody_; }
  /// The blocks of group g: agents [laneCount g, laneCount (g + 1)).
  std::span<const Block> group(std::size_t g) const {
    return {blocks_.data() + rows_[g].start, rows_[g].count};
  }
  /// False if no pair of group g is marked for a daughter.
  bool marked(std::size_t g) const { return marked_[g] != 0; }
  std::size_t bytes() const { return blocks_.size() * sizeof(Block) + rows_.size() * sizeof(rows_[0]); }

 private:
  /// Where a group's blocks are, and how many there is room for.
  struct Row {
    std::uint32_t start = 0, count = 0, room = 0;
  };
  std::size_t groupCount() const { return (size_ + std::size_t{laneCount} - 1) / laneCount; }
  /// Gives every group its blocks and fills them.
  void layOut(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
              bool daughters);
  static Index firstOf(std::size_t g) { return static_cast<Index>(g * laneCount); }
  Index endOf(std::size_t g) const { return std::min(firstOf(g + 1), size_); }
  /// Fills the blocks of group g, or of them what belongs to agent i.
  void fill(std::size_t g, const NeighbourList& neighbours, const BondTable& bonds,
            std::span<const std::uint8_t> flags, bool daughters);
  void fillLane(Index i, const NeighbourList& neighbours, const BondTable& bonds,
                std::span<const std::uint8_t> flags, bool daughters);

  Index size_ = 0, nobody_ = 0;
  std::vector<Block> blocks_;
  std::vector<Row> rows_;
  std::size_t abandoned_ = 0;  ///< blocks that no row uses any more
  std::vector<std::uint8_t> marked_;
};

}  // namespace restenosis
