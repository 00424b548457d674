#pragma once

#include "tissue/vessel/SurfaceFromAxis.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The shape that a wall is packed in (model 2), around a lumen of any section that all of the vessel's axis
/// sees. Distances are from the lumen's surface, outwards.
struct WallShape {
  SurfaceFromAxis iel;           ///< of the centres of the IEL's agents: a cell radius r
  SurfaceFromAxis inner, outer;  ///< that cells' centres lie between: 2 r, and the wall's thickness less 2 r
  SurfaceFromAxis eel;           ///< of the centres of the EEL's agents: the wall's thickness less r
  double ielArea, eelArea;       ///< of these surfaces [m^2]
  double volume;                 ///< of the wall [m^3]
};

/// That of a vessel whose lumen is a cylinder.
WallShape cylindricalShape(const VesselParameters& vessel);

}  // namespace restenosis
