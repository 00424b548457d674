#pragma once

#include <optional>

#include "tissue/vessel/RadiusMap.h"

namespace restenosis {

/// A surface around the vessel's axis that each ray normal to the axis meets once: a cylinder, or a map of
/// its distance from the axis.
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
  /// Area of a surface element over that of its radial projection on a cylinder of radius 1 m about the axis:
  /// the distance from the axis, more where the surface is steep [m].
  double areaElementAt(const Vec3& point) const;

 private:
  std::optional<RadiusMap> map_;
  double least_, greatest_;
};

}  // namespace restenosis
