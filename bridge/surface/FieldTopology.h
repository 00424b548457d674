#pragma once

#include <cstddef>

#include "bridge/surface/BandField.h"
#include "bridge/surface/LumenGrid.h"

namespace restenosis {

/// What `keepLumen` found.
struct LumenTopology {
  bool connected = false;          ///< whether a lumen joins inlet and outlet
  std::size_t cavities = 0;        ///< free spaces without way to the lumen, filled
  std::size_t islands = 0;         ///< detached pieces of tissue in the lumen, removed
  std::size_t floatingStruts = 0;  ///< detached pieces that hold strut, kept
};

/// Makes a distance field (positive: free) describe one lumen: the largest free component (neighbours along
/// the axes) that reaches both ends. Every other free node and every obstacle that neither reaches the
/// grid's sides nor holds a node inside a strut (`strut` < 0; may be null) changes sign. Pieces that touch
/// only diagonally count as separate. Nothing is changed when no component joins the ends.
LumenTopology keepLumen(GridField& field, const BandField* strut);

}  // namespace restenosis
