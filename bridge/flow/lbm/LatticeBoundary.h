#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "LumenLattice.h"

namespace restenosis {

/// How a population that meets the wall comes back.
enum class WallRule {
  bounceBack,   ///< to where it came from, as if the wall lay half a link away: first order at curved walls
  interpolated  ///< with the wall where it is, by central linear interpolation: second order
};

/// What happens at the ends, in lattice units.
struct LatticeEnds {
  enum class Inlet { velocity, pressure, periodic };
  Inlet inlet = Inlet::velocity;
  std::function<Vec3(const Vec3& position)> velocity;  ///< at a point of the inlet [m], for Inlet::velocity
  double inletDensity = 0.0;                           ///< departure from 1, for Inlet::pressure; 3 p
  /// Replaces the sources that follow from the velocity, for Inlet::velocity: by node and direction.
  std::function<double(const d3q19::Step& node, int direction)> source;
};

/// Everything that the surface does to populations, as places in storage. Slot i of a place holds the
/// population that arrives there in direction i, before an even step; see LatticeFlow for the slots between
/// steps.
///
/// A population that leaves node x towards the surface in direction i is found, after an even step, in slot
/// `near` (place x, opposite direction) and is expected by the next step in slot `far` (place x + c_i,
/// direction i); after an odd step the other way round. Rules of links therefore read one and write the
/// other.
struct LatticeBoundary {
  /// far = near + k (behind - here) + source after an even step, near = far - k (behind - here) + source
  /// after an odd one: central linear interpolation (Ginzburg et al. 2008) with k = (1 - 2q) / (1 + 2q); 0 is
  /// bounce-back.
  struct WallLink {
    std::uint32_t near, far, behind, here;
    double k, source;
  };
  /// A surface thinner than a link, between two fluid nodes: both bounce back.
  struct ThinLink {
    std::uint32_t a, b;
  };
  /// A given pressure at an end: what comes in is what comes in at the node one layer further in, with the
  /// density changed so that the line through both layers meets the given one on the plane of the end, half a
  /// spacing out. Developed flow leaves unchanged (non-equilibrium extrapolation, Guo et al. 2002).
  struct PressureLink {
    std::uint32_t near, far, node;  ///< node: of pressureNodes
    std::uint8_t direction;
    double density;
  };
  struct PressureNode {
    std::uint32_t inner;  ///< place of the node one layer further in
    bool outlet;
    std::array<std::uint32_t, 19> neighbour;  ///< places of inner + c_i
  };
  /// A population that leaves at one end and enters at the other: from -> to after a step of that parity.
  struct Passage {
    std::uint32_t evenFrom, evenTo, oddFrom, oddTo;
  };

  std::vector<WallLink> wall;
  std::vector<ThinLink> thin;
  std::vector<PressureLink> pressure;
  std::vector<PressureNode> pressureNodes;
  /// The sum of u_z over those inner nodes of the outlet in the steady state. Sound leaves through the outlet
  /// instead of being thrown back by a fixed pressure: the outlet's density follows the outflow's departure
  /// from this sum, as in a plane wave, and is 0 once they agree. Not used where negative.
  double expectedOutflow = -1.0;
  std::vector<Passage> passages;
};

/// @param region of each triangle of the surface the lattice was made of. Throws std::invalid_argument where
/// ends that should be periodic do not match.
LatticeBoundary makeBoundary(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                             WallRule rule, const LatticeEnds& ends);

}  // namespace restenosis
