#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "bridge/flow/lbm/LatticeBoundary.h"

namespace restenosis {

/// Links through an outlet that lies between the nodes as it may. With a given pressure half a link away,
///   f_back = -f_left + 2 w (rho + 4.5 (c u)^2 - 1.5 u^2) - 3 w (2 tau - 1) (c grad)(c u):
/// anti-bounce-back (Ginzburg et al. 2008) and what shear adds to the even part of the populations and to the
/// odd one between both ends of the link, without which there is no shear at the outlet. The gradient along
/// the link is that to the node behind, or to the wall there. Anti-bounce-back keeps the momentum of a node,
/// and one with few neighbours to take it up would run away: there the equilibrium of the given pressure and
/// of the node's velocity comes back.
template <class Real>
class OpenLinks {
 public:
  OpenLinks(const ColumnLayout& layout, const LatticeBoundary& boundary, double tau);

  std::size_t size() const { return links_.size(); }
  /// Gives the node of each link a kinematic viscosity of its own, by its place.
  void setViscosity(const std::function<double(std::uint32_t place)>& viscosity);
  /// Puts what comes back through a link where the next step expects it; the step before was an even one, or
  /// an odd one (LatticeFlow). Links need not be served in order.
  void serve(std::size_t link, bool afterEven, Real* populations);
  /// Sets the density at the outlet from what has left: sound leaves through it, see
  /// LatticeBoundary::expectedOutflow.
  void releaseSound();
  /// Volume that has left in the last step.
  double outflow() const;

 private:
  using Slot = std::uint32_t;
  struct Node {
    std::array<Slot, d3q19::directions> afterEven, afterOdd;  ///< of what has left in each direction
    Vec3 velocity(const Real* populations, bool even) const;
  };
  struct Link {
    Node node, behind;
    Slot arrivesOdd, arrivesEven;  ///< where the next step, odd or even, takes what comes back
    std::uint8_t direction;
    bool alone;
    double wallBehind, density, outflow;
    std::uint32_t place;
    double shear;  ///< 3 (2 tau - 1)
  };

  double expectedOutflow_, area_, density_ = 0.0;
  std::vector<Link> links_;
};

extern template class OpenLinks<float>;
extern template class OpenLinks<double>;

}  // namespace restenosis
