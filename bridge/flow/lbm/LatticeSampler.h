#pragma once

#include "bridge/flow/lbm/LatticeField.h"

namespace restenosis {

/// The flow of a lattice between its nodes: trilinear over the fluid nodes of the cell around a point, at
/// rest and with the pressure of the others where the cell has nodes outside; for points far from any node,
/// at rest.
class LatticeSampler {
 public:
  explicit LatticeSampler(LatticeField field) : field_(std::move(field)) {}
  FlowPoint operator()(const Vec3& position) const;

 private:
  LatticeField field_;
};

}  // namespace restenosis
