#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bridge/flow/lbm/LatticeBoundary.h"

namespace restenosis {

/// Where the populations of a run's first node arrive before a step, by direction; those of the following
/// nodes follow. After the step the population that left in direction i is found at [opposite(i)].
template <class Real>
using Slots = std::array<Real*, d3q19::directions>;

/// Walls and pressures of a lattice, run by run. What comes back from the surface follows from what left the
/// run in its last step and from what arrives for its next, so a run needs no other: its links are served
/// around its collisions, while its populations are in the cache anyway.
template <class Real>
class RunLinks {
 public:
  RunLinks(const ColumnLayout& layout, const LatticeBoundary& boundary);

  /// Keeps what the links of a run need of what has just left it. `left`: the slots of its last step.
  void keep(std::size_t run, const Slots<Real>& left);
  /// Puts what comes back from the surface where the next step of a run expects it.
  void arrive(std::size_t run, const Slots<Real>& arriving) const;
  /// Sets the density at the outlet from what `keep` saw last: sound leaves through it, see
  /// LatticeBoundary::expectedOutflow.
  void releaseSound();

 private:
  struct Wall {
    std::uint32_t offset : 25;  // in the run; columns with their eight neighbours fit into 32 bits
    std::uint32_t direction : 5;
    std::int32_t inward : 2;
    Real k;
  };
  struct Source {
    std::uint32_t wall;
    Real value;
  };
  struct End {
    std::uint32_t inner;  // offset
    std::int32_t inward;
    std::uint32_t links;
    bool outlet;
    double given;              // density
    double density, velocity;  // at the inner node, before the last collision
  };
  /// Those of a kind in run r: from [r] to below [r + 1].
  using First = std::vector<std::uint32_t>;

  std::vector<Wall> walls_;
  std::vector<Real> kept_;  // of walls_: what left towards the wall, and the interpolation's local part
  std::vector<Source> sources_;
  std::vector<End> ends_;
  First firstWall_, firstSource_, firstEnd_;
  double expectedOutflow_, outletDensity_ = 0.0;
  std::size_t outletNodes_ = 0;
};

extern template class RunLinks<float>;
extern template class RunLinks<double>;

}  // namespace restenosis
