#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "bridge/flow/lbm/SteadyLattice.h"

namespace restenosis {

/// The flow at the nodes of a lattice.
struct LatticeField {
  LatticeFrame frame;
  std::vector<std::int32_t> index;  ///< of points, by node of the box, z fastest; -1 outside the fluid
  std::vector<FlowPoint> points;

  /// Place of a node in `index`; the node must lie in the box.
  std::size_t at(const d3q19::Step& node) const {
    const auto& n = frame.size;
    const auto [x, y, z] = std::array{static_cast<std::size_t>(node[0]), static_cast<std::size_t>(node[1]),
                                      static_cast<std::size_t>(node[2])};
    return (x * static_cast<std::size_t>(n[1]) + y) * static_cast<std::size_t>(n[2]) + z;
  }
};

LatticeField latticeField(const SteadyLattice& solved);

/// Writes an image (.vti) for ParaView: `U` [m/s] and `pressure` [Pa] at the nodes, not a number outside the
/// fluid. A lumen that does not lie along z is turned until it does. Throws WriteFailed.
void writeLatticeField(const std::filesystem::path& file, const LatticeField& field);
/// Throws std::runtime_error, which ends a sentence that begins with the file.
LatticeField readLatticeField(const std::filesystem::path& file);

}  // namespace restenosis
