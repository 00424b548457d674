#pragma once

#include <array>
#include <cmath>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The block of cells that the mesher refines and cuts the lumen out of; about cubic.
struct BackgroundBlock {
  Vec3 low, high;             ///< corners [m]
  std::array<long, 3> cells;  ///< along x, y, z
  int level = 0;              ///< how often cells of the core's size were doubled for it

  /// Edges of a cell that was halved so many times [m].
  Vec3 cell(int halvings) const {
    return (high - low).cwiseQuotient(Vec3(cells[0], cells[1], cells[2])) / std::exp2(halvings);
  }
  /// The centre of the cell, halved so many times, that holds a place [m].
  Vec3 cellCentre(const Vec3& place, int halvings) const {
    const Vec3 edges = cell(halvings);
    const Vec3 number = (place - low).cwiseQuotient(edges).array().floor();
    return low + (number + Vec3::Constant(0.5)).cwiseProduct(edges);
  }
};

}  // namespace restenosis
