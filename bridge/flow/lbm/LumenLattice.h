#pragma once

#include <cstdint>
#include <vector>

#include "bridge/flow/lbm/ColumnLayout.h"
#include "bridge/flow/lbm/D3Q19.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Where the nodes of a lattice are.
struct LatticeFrame {
  Vec3 origin;         ///< of node (0, 0, 0) [m]
  double dx;           ///< spacing [m]
  d3q19::Step size{};  ///< nodes along x, y, z
  int inletLayer = 0;  ///< z of the first nodes behind the inlet
  bool alongZ = true;  ///< all of the lumen lies between the planes of its ends, which are layers
  Vec3 position(const d3q19::Step& n) const { return origin + dx * Vec3(n[0], n[1], n[2]); }
};

/// A link from a fluid node through the surface.
struct SurfaceLink {
  std::uint32_t node;      ///< place of the fluid node
  std::uint8_t direction;  ///< towards the surface
  bool bothFluid;          ///< the node at the other end is fluid as well: a gap thinner than the spacing
  bool interpolable;  ///< the node behind, against the direction, is fluid and reached without a crossing
  double q;           ///< distance to the surface over the length of the link, 0 to 1
  std::uint32_t triangle;   ///< crossed first
  d3q19::Step coordinates;  ///< of the node
};

/// The fluid nodes within a closed surface and their links through it.
struct LumenLattice {
  LatticeFrame frame;
  ColumnLayout layout;
  std::vector<SurfaceLink> links;  ///< sorted by direction, then node

  bool isFluid(const d3q19::Step& node) const;
};

/// Throws std::invalid_argument unless the surface is a sound lumen that a lattice can be put into: along z,
/// or with an inlet that lies so.
void requireLatticeLumen(const TriSurface& lumen);

/// Puts a lattice of about `spacing` [m] into a closed lumen whose inlet is a plane of constant z that the
/// flow enters along z. Where the lumen lies along z (liesAlongZ), the spacing is changed so that a whole
/// number of nodes fits between the planes of the ends, which then lie half a link beyond the first and last
/// nodes. In a bent one the inlet lies half a link before the layer `inletLayer`, the outlet as it may. Fluid
/// are the nodes inside the surface that are connected with inlet and outlet; wall distances are exact.
/// Throws std::invalid_argument where the surface is not a lumen (requireLumen, requireLumenWithPlanarEnds),
/// too large for the spacing
/// (`mostNodes`), or where no connected nodes join inlet and outlet; the message says which setting to
/// change.
LumenLattice makeLumenLattice(const TriSurface& lumen, double spacing, double mostNodes = 1e8);

}  // namespace restenosis
