#pragma once

#include "TriSurface.h"
#include "VesselParameters.h"

namespace restenosis {

/// Radius [m] of the lumen without tissue at axial position z [m]: the vessel's, less a cosine-shaped
/// stenosis of relative depth `stenosis` and length `stenosisLength` half way along.
double cylinderRadius(const VesselParameters& vessel, double z);

/// The closed surface of that lumen, for scenes without tissue, with triangles about `spacing` [m] wide. The
/// polygons' areas equal the circles' (their corners lie sqrt(x / sin x) outside, x = 2 pi / corners),
/// because wall shear stress goes with the third power of the radius. Throws std::invalid_argument for a
/// spacing that is not positive or a stenosis that leaves no lumen.
TriSurface cylinderSurface(const VesselParameters& vessel, double spacing = 20e-6);

}  // namespace restenosis
