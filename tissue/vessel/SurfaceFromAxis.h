#pragma once

#include <optional>

#include "tissue/vessel/RadiusMap.h"

namespace restenosis {

/// A surface around the vessel's axis that is seen from all of the axis: a cylinder, or one whose distance
/// from the axis is mapped.
class SurfaceFromAxis {
 public:
  /// A cylinder of this radius [m].
  explicit SurfaceFromAxis(double radius) : least_(radius), greatest_(radius) {}
  /// `map` must not be empty.
  explicit SurfaceFromAxis(RadiusMap map);

  bool isCylinder() const { return !map_; }
  /// Distance of the surface from the axis at the point's angle and place along the vessel [m].
  double at(const Vec3& point) const { return map_ ? map_->at(point) : least_; }
  /// Unit vector out of the surface there.
  Vec3 normalAt(const Vec3& point) const;
  /// Bounds of `at` [m].
  double least() const { return least_; }
  double greatest() const { return greatest_; }
  /// Area of a piece of the surface at a point, over that of its shadow on a cylinder of radius 1 m about the
  /// axis: the distance from the axis, more where the surface is steep [m].
  double areaElementAt(const Vec3& point) const;

 private:
  std::optional<RadiusMap> map_;
  double least_, greatest_;
};

}  // namespace restenosis
