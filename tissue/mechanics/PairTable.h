#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "BondTable.h"
#include "NeighbourList.h"

namespace restenosis {

/// Who acts on whom: of each agent its neighbours and bond partners in ascending order, each once, and with
/// each the rest length of the bond. An agent's row is a piece of memory of its own, so that few agents from
/// anywhere cost no more each than all of them.
class PairTable {
 public:
  /// So many partners of one agent, a cache line.
  static constexpr int width = 8;
  struct alignas(64) Block {
    std::array<Index, width> partner;
    /// Rest length of the bond [m], infinite where there is none. Negative where either of the pair is a
    /// daughter.
    std::array<float, width> rest;
  };

  /// `flags`: of the agents. `daughters`: whether pairs with a daughter are to be marked. All three have the
  /// same number of agents.
  void build(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
             bool daughters);
  /// The same where, since the last build or update, only the neighbours of the agents `changed`, in
  /// ascending order, did. Agents appended since are among these, and all fit below nobody().
  void update(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
              bool daughters, std::span<const Index> changed);

  Index size() const { return static_cast<Index>(rows_.size()); }
  /// An index that no agent has; there is room for an eighth more agents below it than there were when the
  /// table was built.
  Index nobody() const { return nobody_; }
  /// Length of an agent's row; it may end in nobody(), as the last of its blocks does.
  std::uint32_t length(Index i) const { return rows_[i].length; }
  /// The first of an agent's blocks; valid until the next build or update.
  const Block* row(Index i) const { return blocks_.data() + rows_[i].start; }
  /// False if no pair of the agent is marked for a daughter.
  bool marked(Index i) const { return rows_[i].marked != 0; }
  std::size_t bytes() const { return blocks_.size() * sizeof(Block) + rows_.size() * sizeof(rows_[0]); }

 private:
  /// Where an agent's blocks are, and how many there are beyond those of its length.
  struct Row {
    std::uint32_t start = 0;
    std::uint32_t length : 24 = 0, spare : 7 = 0, marked : 1 = 0;
    std::uint32_t blocks() const { return (length + width - 1) / width; }
  };
  /// Gives every agent its blocks and fills them.
  void layOut(const NeighbourList& neighbours, const BondTable& bonds, std::span<const std::uint8_t> flags,
              bool daughters);
  void fill(Index i, const NeighbourList& neighbours, const BondTable& bonds,
            std::span<const std::uint8_t> flags, bool daughters);

  Index nobody_ = 0;
  std::vector<Block> blocks_;
  std::vector<Row> rows_;
  std::size_t abandoned_ = 0;  ///< blocks that no row uses any more
};

}  // namespace restenosis
