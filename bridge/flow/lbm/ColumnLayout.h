#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bridge/flow/lbm/D3Q19.h"

namespace restenosis {

/// Consecutive fluid nodes of one column.
struct NodeRun {
  std::int32_t x, y, z;  ///< first node
  std::uint32_t first;   ///< its place
  std::uint32_t count;
};

/// Where the nodes of a sparse lattice are stored. The lattice is sparse in x and y and dense along z, the
/// long side of a vessel: each column of nodes is stored from one node before the first fluid node of it and
/// its eight neighbours to one after their last, so every neighbour of a fluid node has a place, and nodes
/// that follow each other in z follow each other in memory, in all columns with the same alignment.
class ColumnLayout {
 public:
  /// Nodes with coordinates from 0 to below `size`; `fluid(x, y, z)` tells which are fluid. Throws
  /// std::length_error where places times directions exceed 32 bits.
  ColumnLayout(const d3q19::Step& size, const std::function<bool(int, int, int)>& fluid);

  /// Place of a node; z may lie one outside a fluid node or its neighbours. Must be stored.
  std::uint32_t place(int x, int y, int z) const { return static_cast<std::uint32_t>(offset(x, y) + z); }
  std::uint32_t place(const d3q19::Step& n) const { return place(n[0], n[1], n[2]); }
  /// Place of (x, y, 0), which need not be stored itself.
  std::int64_t offset(int x, int y) const { return offsets_[column(x, y)]; }

  const std::vector<NodeRun>& runs() const { return runs_; }
  std::size_t fluidNodes() const { return fluidNodes_; }
  /// Number of places, a multiple of `alignment`.
  std::uint32_t places() const { return places_; }
  const d3q19::Step& size() const { return size_; }

  static constexpr int alignment = 16;  ///< nodes; a cache line of single precision

 private:
  std::size_t column(int x, int y) const {
    return static_cast<std::size_t>(x + 1) * static_cast<std::size_t>(size_[1] + 2) +
           static_cast<std::size_t>(y + 1);
  }

  d3q19::Step size_;
  std::vector<std::int64_t> offsets_;
  std::vector<NodeRun> runs_;
  std::size_t fluidNodes_ = 0;
  std::uint32_t places_ = 0;
};

}  // namespace restenosis
