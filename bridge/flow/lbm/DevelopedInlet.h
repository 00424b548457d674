#pragma once

#include <optional>
#include <vector>

#include "bridge/flow/ViscosityLaw.h"
#include "bridge/flow/lbm/LatticeBoundary.h"
#include "bridge/flow/lbm/LatticeFlow.h"
#include "bridge/flow/lbm/LumenLattice.h"

namespace restenosis {

/// Developed flow through the inlet's cross-section, whatever its shape, as sources for the links of the
/// inlet.
///
/// The lumen is thought to go on before its inlet with the cross-section of its first layer of nodes.
/// Developed flow there is that of one layer of the lattice, periodic along z and driven by a force. Solved
/// on that layer, it gives the difference between the population that comes in through each link of the inlet
/// and the one that leaves through it. With these sources developed flow enters unchanged, as bounce-back
/// with a velocity does not let it: that leaves an error of first order in the velocity's gradient, which
/// flattens the profile by some per cent.
class DevelopedInlet {
 public:
  /// @param flowRate through the inlet  @param thinning how blood thins; both in lattice units
  DevelopedInlet(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region, WallRule rule,
                 const LatticeRelaxation& relaxation, double flowRate,
                 const std::optional<ViscosityLaw>& thinning = {});

  /// Source of the link of a node of the first layer in a direction with c_z = -1; sums to the flow rate over
  /// all links.
  double source(const d3q19::Step& node, int direction) const;

 private:
  LumenLattice layer(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region) const;

  LumenLattice layer_;
  std::vector<double> sources_;  ///< by direction and place
};

}  // namespace restenosis
