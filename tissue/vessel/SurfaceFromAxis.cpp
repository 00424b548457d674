#include "tissue/vessel/SurfaceFromAxis.h"

#include <algorithm>
#include <utility>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {

SurfaceFromAxis::SurfaceFromAxis(RadiusMap map)
    : map_(std::move(map)),
      least_(std::ranges::min(map_->values())),
      greatest_(std::ranges::max(map_->values())) {}

Vec3 SurfaceFromAxis::normalAt(const Vec3& point) const {
  return map_ ? map_->normalAt(point) : radialAt(point);
}

double SurfaceFromAxis::areaElementAt(const Vec3& point) const {
  return at(point) / normalAt(point).dot(radialAt(point));
}

}  // namespace restenosis
