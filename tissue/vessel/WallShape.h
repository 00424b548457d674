#pragma once

#include "tissue/vessel/SurfaceFromAxis.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The shape that a wall is packed in (model 2), around a lumen that each ray normal to the vessel's axis
/// meets once. Distances are from the lumen's surface, outwards.
struct WallShape {
  SurfaceFromAxis iel;           ///< of the centres of the IEL's agents: a cell radius r
  SurfaceFromAxis inner, outer;  ///< bounds of cells' centres: 2 r, and the wall's thickness less 2 r
  SurfaceFromAxis eel;           ///< of the centres of the EEL's agents: the wall's thickness less r
  double ielArea, eelArea;       ///< of these surfaces [m^2]
  double volume;                 ///< of the wall [m^3]
};

/// The shape of a vessel with a cylindrical lumen.
WallShape cylindricalShape(const VesselParameters& vessel);

}  // namespace restenosis
