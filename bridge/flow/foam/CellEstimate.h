#pragma once

#include "bridge/flow/foam/FoamSettings.h"

namespace restenosis {

/// What the number of cells of a lumen's mesh goes with.
struct LumenSize {
  double volume = 0;     ///< [m^3]
  double wallArea = 0;   ///< of the side without struts [m^2]
  double strutArea = 0;  ///< of the struts in it [m^2]
};

/// Cells that the mesher makes in a lumen, from where it refines (model/flow.md, cells): the core's cells,
/// and 8 for one in a band along the side, 64 where a second level is asked for.
double expectedCells(const LumenSize& lumen, const FoamSettings& settings);

}  // namespace restenosis
