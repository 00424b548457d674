#pragma once

#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Radius [m] of the lumen without tissue at axial position z [m]: the vessel's, less a cosine-shaped
/// stenosis of relative depth `stenosis` and length `stenosisLength` half way along.
double cylinderRadius(const VesselParameters& vessel, double z);

/// How wide the triangles of a cylinder's surface are [m].
struct CylinderSpacing {
  double around, along;
};

/// The same share of the diameter for every vessel, so that scaled vessels have scaled surfaces: 20 um for
/// 1.8 mm, which makes 283 corners (assumed). In a vessel narrower than 1.8 mm and longer than 10,000 such
/// triangles they are longer than wide, but no longer than 20 um.
CylinderSpacing cylinderSpacing(const VesselParameters& vessel);

/// The closed surface of that lumen, for scenes without tissue. The polygons' areas equal the circles' (their
/// corners lie sqrt(x / sin x) outside, x = 2 pi / corners), because wall shear stress goes with the third
/// power of the radius. Throws std::invalid_argument for a spacing that is not positive or a stenosis that
/// leaves no lumen.
TriSurface cylinderSurface(const VesselParameters& vessel, const CylinderSpacing& spacing);

/// The same with `cylinderSpacing`.
TriSurface cylinderSurface(const VesselParameters& vessel);

}  // namespace restenosis
