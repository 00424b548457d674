#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bridge/flow/lbm/LumenLattice.h"
#include "bridge/flow/lbm/WallFit.h"
#include "bridge/surface/NearestTriangle.h"

namespace restenosis {

/// Exact distances of nodes from wall and struts, each found once.
class WallDistances {
 public:
  /// Both must outlive this.
  WallDistances(const TriSurface& lumen, const LumenLattice& lattice);

  /// The nodes near a place [m] are wanted.
  void add(const Vec3& centre, const std::vector<NearNode>& nodes);
  /// Finds the distances of all that are wanted, and not found yet.
  void find();
  /// Sets the wall distance of nodes that were added before.
  void set(std::vector<NearNode>& nodes) const;

 private:
  struct Wanted {
    std::uint32_t place;
    Vec3 position;  ///< [m]
  };
  const TriSurface& lumen_;
  const LumenLattice& lattice_;
  std::unique_ptr<NearestTriangle> wall_;  ///< made when the first is wanted: a coarse lattice wants none
  std::vector<Wanted> wanted_;
  std::vector<double> distance_;  ///< by place [spacings]; negative where not wanted
};

}  // namespace restenosis
