#include "LumenGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace restenosis {
namespace {

/// A coordinate as the lower node of its interval and the fraction of the way to the next.
struct Place {
  int lower;
  double fraction;
  Place(double coordinate, double origin, double spacing, int nodes) {
    const double s = std::clamp((coordinate - origin) / spacing, 0.0, static_cast<double>(nodes - 1));
    lower = std::min(static_cast<int>(s), nodes - 2);
    fraction = s - lower;
  }
};

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

LumenGrid::LumenGrid(double vesselLength, double halfWidth, double resolution) {
  if (!(vesselLength > 0 && halfWidth > 0 && resolution > 0) || !std::isfinite(vesselLength + halfWidth))
    throw std::invalid_argument("a lumen grid needs a positive length, width and resolution");
  length = vesselLength;
  spacing = resolution;
  nz = std::max(2, static_cast<int>(std::lround(length / resolution))) + 1;
  spacingZ = length / (nz - 1);
  nx = ny = 2 * std::max(1, static_cast<int>(std::ceil(halfWidth / resolution))) + 1;
}

double GridField::at(const Vec3& point) const {
  Vec3 unused;
  return at(point, unused);
}

double GridField::at(const Vec3& point, Vec3& gradient) const {
  const LumenGrid& g = grid;
  const Place a(point.x(), g.x(0), g.spacing, g.nx), b(point.y(), g.y(0), g.spacing, g.ny),
      c(point.z(), 0.0, g.spacingZ, g.nz);
  const std::size_t origin = g.index(a.lower, b.lower, c.lower);
  const std::size_t up = g.nx, over = static_cast<std::size_t>(g.nx) * g.ny;
  const float* v = values.data() + origin;
  const double v00 = mix(v[0], v[1], a.fraction), v10 = mix(v[up], v[up + 1], a.fraction),
               v01 = mix(v[over], v[over + 1], a.fraction),
               v11 = mix(v[over + up], v[over + up + 1], a.fraction);
  const double low = mix(v00, v10, b.fraction), high = mix(v01, v11, b.fraction);
  gradient.x() = mix(mix(v[1] - v[0], v[up + 1] - v[up], b.fraction),
                     mix(v[over + 1] - v[over], v[over + up + 1] - v[over + up], b.fraction), c.fraction) /
                 g.spacing;
  gradient.y() = mix(v10 - v00, v11 - v01, c.fraction) / g.spacing;
  gradient.z() = (high - low) / g.spacingZ;
  return mix(low, high, c.fraction);
}

double GridField::inPlane(double x, double y, int k) const {
  const LumenGrid& g = grid;
  const Place a(x, g.x(0), g.spacing, g.nx), b(y, g.y(0), g.spacing, g.ny);
  const float* v = values.data() + g.index(a.lower, b.lower, k);
  return mix(mix(v[0], v[1], a.fraction), mix(v[g.nx], v[g.nx + 1], a.fraction), b.fraction);
}

}  // namespace restenosis
