#pragma once

#include <vector>

#include "bridge/flow/foam/PolyMesh.h"

namespace restenosis {

/// Which way a point of a mesh may move by itself.
enum class PointFreedom : std::uint8_t {
  given,    ///< not at all: its displacement is prescribed
  inPlane,  ///< in x and y, along a planar end
  all
};

/// Carries prescribed displacements into a mesh: those of the free points are the weighted means of their
/// neighbours along the edges, which is a Laplace equation on the points. An edge weighs 1 / (length d^2)
/// with the distance d from the nearest prescribed point: cells near the wall move as it does, and those far
/// from it take up the deformation. No displacement exceeds the largest prescribed one.
/// `displacements` are read at prescribed points and written at free ones, each to 1e-4 of the largest
/// (assumed; what is left is a smooth error inside the mesh, never on its wall). Throws std::runtime_error
/// where no solution is found.
void moveInside(const PolyMesh& mesh, const std::vector<PointFreedom>& freedom,
                std::vector<Vec3>& displacements);

}  // namespace restenosis
