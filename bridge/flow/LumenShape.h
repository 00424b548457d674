#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A planar end of a lumen, a plane of constant z.
struct LumenEnd {
  double z;     ///< [m]
  double area;  ///< [m^2]
  Vec3 centre;  ///< centroid of the end [m]
};

/// Throws std::invalid_argument, saying what is wrong, unless the surface can be meshed: finite vertices,
/// every edge shared by two triangles in opposite directions, normals outwards, two ends that are planes of
/// constant z, the inlet below the outlet.
void requireLumen(const TriSurface& lumen);

/// The end that carries this region (inlet or outlet). Throws std::invalid_argument where there is none or it
/// is no plane of constant z.
LumenEnd lumenEnd(const TriSurface& lumen, SurfaceRegion end);

/// A planar end of a lumen in any direction.
struct EndPlane {
  Vec3 centre;             ///< centroid of the end [m]
  Vec3 normal;             ///< unit vector out of the lumen
  double area;             ///< [m^2]
  double perimeter = 0.0;  ///< of all its rims [m]
};

/// The end that carries this region (the inlet or an outlet). Throws std::invalid_argument where there is
/// none or it is not planar.
EndPlane endPlane(const TriSurface& lumen, SurfaceRegion end);

/// The edges around the end that carries this region, as its triangles go around them, in ascending order.
/// None where there is no such end.
std::vector<std::array<std::uint32_t, 2>> endRim(const TriSurface& lumen, SurfaceRegion end);

/// requireLumen for a lumen of any shape, whose planar ends may face in any directions.
void requireLumenWithPlanarEnds(const TriSurface& lumen);

/// Whether the lumen lies along z: it has one outlet, its ends are planes of constant z, the inlet below the
/// outlet, and all of it lies between them.
bool liesAlongZ(const TriSurface& lumen);

/// A lumen in a plane of constant z.
struct CrossSection {
  double area;       ///< [m^2]
  double perimeter;  ///< [m]
  Vec3 centre;       ///< centroid [m]; not a number where there is no area
};

/// The lumen in each plane z = stations[i] [m], in ascending order: the signed area of the contour in which
/// the plane cuts the surface, so islands count negative, its length, and its centroid.
std::vector<CrossSection> crossSections(const TriSurface& lumen, std::span<const double> stations);

/// The areas of crossSections alone [m^2].
std::vector<double> crossSectionAreas(const TriSurface& lumen, std::span<const double> stations);

}  // namespace restenosis
