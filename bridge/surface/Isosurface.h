#pragma once

#include "bridge/surface/BandField.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// How an isosurface is made a good mesh.
struct IsosurfaceSettings {
  int relaxations = 5;  ///< passes that even out triangles within the surface (assumed)
  double nodeClearance =
      0.02;  ///< least |distance| at a node over the spacing: keeps vertices apart (assumed)
};

/// The closed surface of where a field is above 0 (flying edges), with planar caps exactly at z = 0 and
/// z = length, normals outwards. Vertices are then moved towards the centre of their neighbours and back onto
/// the isosurface (rims and caps within their plane), so that slivers disappear and the shape stays. Regions:
/// inlet and outlet for the caps, else wall. Where the field is nowhere above 0, there are no triangles.
TriSurface isosurface(const BandField& field, const IsosurfaceSettings& settings = {});

}  // namespace restenosis
