#pragma once

#include <optional>
#include <span>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// How far the wall shear stress in a straight tube is from that of developed flow, 4 mu U / R by
/// Poiseuille's law or, where blood thins, that of TubeFlow: what a mesh and a scheme cost where the answer
/// is known. Errors are relative to it and weighted by area.
struct PoiseuilleError {
  /// Left out at either end [m] (assumed: 0.1 mm, a cell of the coarsest fidelity; as much more as the tube
  /// is wider than 1.8 mm): there the velocity given at the inlet vanishes on a circle, and not on the
  /// polygon that the mesh makes of it.
  double endMargin = 0.0;
  double exact = 0.0;    ///< of developed flow [Pa]
  double mean = 0.0;     ///< of the magnitude, signed
  double l2 = 0.0;       ///< root of the mean square
  double largest = 0.0;  ///< of all faces
};

/// The error in a tube of this diameter [m] along z from 0 to `length` [m], at a fixed flow rate; nothing
/// where it has no faces between its ends' margins.
std::optional<PoiseuilleError> poiseuilleError(std::span<const WallFace> faces, double diameter,
                                               double length, const FlowConditions& conditions);

}  // namespace restenosis
