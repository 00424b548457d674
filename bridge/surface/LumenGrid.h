#pragma once

#include <cstddef>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Nodes of a regular grid around a straight vessel. The first and last plane of nodes lie exactly on the
/// vessel's ends z = 0 and z = length.
struct LumenGrid {
  /// A grid that reaches `halfWidth` [m] from the axis in x and y, with nodes `resolution` [m] apart (in z as
  /// near to it as the length allows). Throws std::invalid_argument unless all three are positive and finite.
  LumenGrid(double length, double halfWidth, double resolution);
  bool operator==(const LumenGrid&) const = default;

  double length;   ///< of the vessel [m]
  double spacing;  ///< in x and y [m]
  double spacingZ;
  int nx, ny, nz;  ///< numbers of nodes

  double x(int i) const { return (i - (nx - 1) / 2) * spacing; }
  double y(int j) const { return (j - (ny - 1) / 2) * spacing; }
  double z(int k) const { return k == nz - 1 ? length : k * spacingZ; }
  Vec3 node(int i, int j, int k) const { return {x(i), y(j), z(k)}; }
  std::size_t row(int j, int k) const { return (static_cast<std::size_t>(k) * ny + j) * nx; }
  std::size_t index(int i, int j, int k) const { return row(j, k) + i; }
  std::size_t planeSize() const { return static_cast<std::size_t>(nx) * ny; }
  std::size_t size() const { return static_cast<std::size_t>(nx) * ny * nz; }
};

/// One number a node of a grid.
struct GridField {
  GridField(const LumenGrid& nodes, float value) : grid(nodes), values(nodes.size(), value) {}

  LumenGrid grid;
  std::vector<float> values;
};

}  // namespace restenosis
