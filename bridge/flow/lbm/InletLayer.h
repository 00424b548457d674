#pragma once

#include <cstdint>
#include <vector>

#include "bridge/flow/lbm/LumenLattice.h"

namespace restenosis {

/// The nodes in the first layer behind the inlet that belong to its cross-section: all fluid ones of a lumen
/// along z; of a bent one, which may come back to that layer, those that are joined within it to a node next
/// to the inlet.
class InletLayer {
 public:
  /// @param region of each triangle of the surface the lattice was made of
  InletLayer(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region);

  bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < size_[0] && y < size_[1] && nodes_[at(x, y)] == joined;
  }
  bool contains(const d3q19::Step& node) const { return node[2] == layer_ && contains(node[0], node[1]); }
  int layer() const { return layer_; }

 private:
  static constexpr std::uint8_t solid = 0, fluid = 1, joined = 2;
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(x * size_[1] + y); }
  /// Joins the fluid nodes that links within the layer lead to without a crossing.
  void spread(const LumenLattice& lattice, std::vector<d3q19::Step> from);

  d3q19::Step size_;
  int layer_;
  std::vector<std::uint8_t> nodes_;
};

}  // namespace restenosis
