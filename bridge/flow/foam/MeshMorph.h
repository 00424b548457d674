#pragma once

#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/PolyMesh.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A mesh moved onto another lumen.
struct MeshMorph {
  std::vector<Vec3> points;  ///< of the mesh [m]
  double movement = 0.0;     ///< of the wall point that moved farthest [m]
  double departure = 0.0;    ///< largest distance of the mesh's wall from the lumen, or of it from that [m]
};

/// Moves the points of a mesh so that its wall lies on a lumen along z [m]. Points of the patches wall
/// and strut go to the nearest place of the lumen, whether wall or strut; those on the rims of the ends to
/// the nearest place of the lumen's rim. The others follow (moveInside), those on an end within its plane.
/// Throws std::runtime_error where the mesh lacks a patch or its ends do not lie in the lumen's.
MeshMorph morphOnto(const PolyMesh& mesh, const TriSurface& lumen);

/// Gives faces the region of the lumen that they are nearest to: on a moved mesh, tissue may have grown over
/// what its patches call a strut, or laid one bare.
void takeRegions(std::vector<WallFace>& faces, const TriSurface& lumen);

}  // namespace restenosis
