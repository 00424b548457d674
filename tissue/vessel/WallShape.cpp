#include "tissue/vessel/WallShape.h"

#include <numbers>

namespace restenosis {

WallShape cylindricalShape(const VesselParameters& vessel) {
  using std::numbers::pi;
  const double lumen = vessel.lumenDiameter / 2, outside = lumen + vessel.wallThickness;
  const double iel = lumen + vessel.cellRadius, eel = lumen + vessel.wallThickness - vessel.cellRadius;
  return {.iel = SurfaceFromAxis(iel),
          .inner = SurfaceFromAxis(iel + vessel.cellRadius),
          .outer = SurfaceFromAxis(eel - vessel.cellRadius),
          .eel = SurfaceFromAxis(eel),
          .ielArea = 2 * pi * iel * vessel.length,
          .eelArea = 2 * pi * eel * vessel.length,
          .volume = pi * (outside * outside - lumen * lumen) * vessel.length};
}

}  // namespace restenosis
