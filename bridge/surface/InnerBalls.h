#pragma once

#include <optional>
#include <vector>

#include "bridge/surface/DistanceField.h"
#include "bridge/surface/NearestTriangle.h"

namespace restenosis {

/// A triangle by its corners [m], in the order that its outward normal follows by the right-hand rule.
using Facet = std::array<Vec3, 3>;

/// Balls inside a closed surface that touch it: as large as the solid is thick, up to a largest radius.
class InnerBalls {
 public:
  /// `facets`: the surface, normals outwards, none of them longer than the solid's parts by much (see
  /// NearestTriangle). Balls have a radius of at most `largest` [m], and no ball is smaller than `least` [m].
  InnerBalls(const std::vector<Facet>& facets, double largest, double least);

  /// The ball that comes nearest to a place of the surface, where the outward normal is `normal`: it touches
  /// the surface there, or, near a convex edge or corner, its other faces too, so that it is flush with all
  /// of them. Its radius is `largest`, or half of the solid's thickness where that is less; it lies inside
  /// the solid, exactly, and comes as near to the faces it touches as 1 % of its radius. None where the solid
  /// is too thin for any, as at the tip of a wedge.
  std::optional<Ball> at(const Vec3& place, const Vec3& normal) const;

 private:
  std::optional<Ball> ofRadius(double& radius, const Vec3& place, const Vec3& normal) const;

  double largest_, least_;
  std::vector<Vec3> normals_;
  NearestTriangle nearest_;
};

}  // namespace restenosis
