#pragma once

#include "bridge/flow/foam/PolyMesh.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Cells of an O-grid.
struct OGridSize {
  int around = 0;  ///< around the wall; a multiple of four
  int layers = 0;  ///< between the square core and the wall
  int along = 0;   ///< from the inlet to the outlet
};

/// A structured mesh of a lumen along z: a square core of hexahedra and layers around it, whose corners lie
/// on rays from the line between the centres of the ends. Its wall is where these rays leave the lumen, each
/// taken as the mean of nine around it, so that it follows what the mesh can show; what lies in an undercut
/// is left out, and steps are ramps of one cell. Patches: inlet, outlet and wall.
///
/// Throws std::invalid_argument where the lumen cannot be seen from that line, or has undercuts in more than
/// a hundredth of its sides.
PolyMesh oGrid(const TriSurface& lumen, const OGridSize& size);

}  // namespace restenosis
