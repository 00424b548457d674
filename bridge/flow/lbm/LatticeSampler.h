#pragma once

#include <vector>

#include "bridge/flow/lbm/SteadyLattice.h"

namespace restenosis {

/// The flow of a lattice between its nodes: trilinear over the fluid nodes of the cell around a point, at
/// rest and with the pressure of the others where the cell has nodes outside; for points far from any node,
/// at rest.
class LatticeSampler {
 public:
  explicit LatticeSampler(const SteadyLattice& solved);
  FlowPoint operator()(const Vec3& position) const;

 private:
  LatticeFrame frame_;
  std::vector<std::int32_t> index_;  ///< of points_, by node of the box; -1 outside the fluid
  std::vector<FlowPoint> points_;
};

}  // namespace restenosis
