#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bridge/surface/PointTree.h"

namespace restenosis {

/// The place on a set of triangles that is nearest to a point, exactly. Fast where the triangles are of about
/// one size: the largest sets how many are looked at.
class NearestTriangle {
 public:
  /// Throws std::invalid_argument where there are no triangles.
  NearestTriangle(std::vector<Vec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles);

  struct Place {
    Vec3 point;
    double distance;       ///< in the unit of the vertices
    std::size_t triangle;  ///< that it lies on
  };
  /// Of triangles equally near, the first in the tree's order, which is fixed.
  Place at(const Vec3& point) const;

 private:
  Vec3 onTriangle(std::size_t triangle, const Vec3& point) const;

  std::vector<Vec3> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  PointTree centres_;
  std::vector<double> reaches_;  ///< of each triangle, how far its corners are from its centre at most
  double reach_ = 0.0;           ///< the largest of these
};

}  // namespace restenosis
