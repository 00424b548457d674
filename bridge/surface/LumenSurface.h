#pragma once

#include <stdexcept>

#include "bridge/surface/LumenField.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Thrown when a surface is asked of a lumen that does not join inlet and outlet.
struct Occluded : std::runtime_error {
  Occluded() : std::runtime_error("the lumen is occluded: nothing open joins inlet and outlet") {}
};

/// How an isosurface is made a good mesh.
struct LumenSurfaceSettings {
  int relaxations = 5;  ///< passes that even out triangles within the surface (assumed)
  double nodeClearance =
      0.02;  ///< least |distance| at a node over the spacing: keeps vertices apart (assumed)
};

/// The closed surface of a lumen: isosurface 0 of the field (flying edges), planar caps exactly at z = 0 and
/// z = length, normals out of the lumen. Vertices are then moved towards the centre of their neighbours
/// and back onto the isosurface (rims and caps within their plane), so that slivers disappear and the shape
/// stays. Regions: wall or strut by the nearer of the two, inlet and outlet for the caps. Throws Occluded.
TriSurface extractSurface(const LumenField& field, const LumenSurfaceSettings& settings = {});

}  // namespace restenosis
