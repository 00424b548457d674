#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A tree of boxes around the triangles of a surface, halved by number along the longest axis: finds those
/// near a segment, whatever their sizes and shapes.
class TriangleBoxes {
 public:
  /// Boxes are wider by `margin` [m] on every side, which also makes up for rounding.
  TriangleBoxes(const TriSurface& surface, double margin);

  /// Calls visit(triangle) for those whose neighbourhood the segment from `a` to `b` [m] passes: all that it
  /// meets, and some more. In the tree's order, which is fixed.
  template <class Visit>
  void along(const Vec3& a, const Vec3& b, Visit&& visit) const {
    const Vec3 middle = 0.5 * (a + b), half = 0.5 * (b - a);
    std::vector<std::uint32_t> left;
    if (!nodes_.empty()) left.push_back(0);
    while (!left.empty()) {
      const Node& node = nodes_[left.back()];
      left.pop_back();
      if (!node.meets(middle, half)) continue;
      if (node.second == 0) {
        for (std::uint32_t n = node.first; n < node.first + node.count; ++n) visit(order_[n]);
      } else {
        left.push_back(node.second);
        left.push_back(node.first);
      }
    }
  }

 private:
  struct Node {
    Vec3 centre = Vec3::Zero(), reach = Vec3::Zero();  ///< of its box, half as long as its sides
    std::uint32_t first = 0;                           ///< child, or of a leaf its first triangle in order_
    std::uint32_t second = 0;                          ///< child; 0 for a leaf
    std::uint32_t count = 0;                           ///< of a leaf's triangles

    /// Whether no axis of the box, nor one across it and the segment, tells the two apart.
    bool meets(const Vec3& middle, const Vec3& half) const {
      const Vec3 between = middle - centre, extent = half.cwiseAbs();
      if ((between.cwiseAbs().array() > (reach + extent).array()).any()) return false;
      const Vec3 across = half.cross(between).cwiseAbs();
      return across.x() <= reach.y() * extent.z() + reach.z() * extent.y() &&
             across.y() <= reach.x() * extent.z() + reach.z() * extent.x() &&
             across.z() <= reach.x() * extent.y() + reach.y() * extent.x();
    }
  };

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< triangles, those of each leaf together
};

}  // namespace restenosis
