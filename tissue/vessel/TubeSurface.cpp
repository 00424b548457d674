#include "TubeSurface.h"

#include <algorithm>
#include <utility>

#include "Cylindrical.h"

namespace restenosis {

TubeSurface::TubeSurface(RadiusMap map)
    : map_(std::move(map)),
      least_(std::ranges::min(map_->values())),
      greatest_(std::ranges::max(map_->values())) {}

Vec3 TubeSurface::normalAt(const Vec3& point) const { return map_ ? map_->normalAt(point) : radialAt(point); }

double TubeSurface::areaElementAt(const Vec3& point) const {
  return at(point) / normalAt(point).dot(radialAt(point));
}

}  // namespace restenosis
