#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bridge/flow/lbm/LumenLattice.h"

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
  /// Gradient of the density along the flow at an outlet that is no layer, times the unit vector.
  Vec3 outletGradient = Vec3::Zero();
};

/// Everything that the surface does to populations, as places in storage. Slot i of a place holds the
/// population that arrives there in direction i, before an even step; see LatticeFlow for the slots between
/// steps. Links of walls and pressures leave a fluid node in a direction; what comes back arrives at that
/// node in the opposite one.
struct LatticeBoundary {
  /// Back comes what left towards the wall, and k times the difference of what arrives in the link's
  /// direction and what left in the opposite one: central linear interpolation (Ginzburg et al. 2008) with k
  /// = (1 - 2q) / (1 + 2q); 0 is bounce-back. That difference is taken at the node, or `inward` in z of it
  /// where nothing arrives at the node itself.
  struct WallLink {
    std::uint32_t node;  ///< place
    std::uint8_t direction;
    std::int8_t inward;
    double k, source;
  };
  /// A surface thinner than a link, between two fluid nodes: both bounce back. Slots of the two.
  struct ThinLink {
    std::uint32_t a, b;
  };
  /// A given pressure at an end: what comes in is what comes in at the node one layer further in, with the
  /// density changed so that the line through both layers meets the given one on the plane of the end, half a
  /// spacing out. Developed flow leaves unchanged (non-equilibrium extrapolation, Guo et al. 2002).
  struct PressureNode {
    std::uint32_t node;  ///< place, next to the end
    std::int8_t inward;  ///< step in z to the node further in
    bool outlet;
    std::uint32_t links;  ///< bit i: the link in direction i leads through the end
    double density;       ///< departure from 1
  };
  /// A population that leaves at one end and enters at the other: from -> to after a step of that parity.
  struct Passage {
    std::uint32_t evenFrom, evenTo, oddFrom, oddTo;
  };

  /// A link through an outlet that is no layer of the lattice: OpenLinks.
  struct OpenLink {
    d3q19::Step node;
    std::uint8_t direction;
    double wallBehind;  ///< distance to the wall behind, against the direction; 0 where there is a node
    bool alone;         ///< few neighbours of the node are fluid
    double density;     ///< departure from 1, half a link away
  };

  std::vector<WallLink> wall;
  std::vector<OpenLink> open;
  std::vector<ThinLink> thin;
  std::vector<PressureNode> pressureNodes;
  /// The sum of u_z over those inner nodes of the outlet in the steady state, or the flow through open links.
  /// Sound leaves through the outlet instead of being thrown back by a fixed pressure: the outlet's density
  /// follows the outflow's departure from this sum, as in a plane wave, and is 0 once they agree. Not used
  /// where negative, nor with a force.
  double expectedOutflow = -1.0;
  double outletArea = 0.0;  ///< of open links, in squares of the spacing
  std::vector<Passage> passages;
};

/// @param region of each triangle of the surface the lattice was made of. Throws std::invalid_argument where
/// ends that should be periodic do not match.
LatticeBoundary makeBoundary(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                             WallRule rule, const LatticeEnds& ends);

}  // namespace restenosis
