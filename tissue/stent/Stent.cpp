#include "tissue/stent/Stent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

/// Distance to an ellipse with semi-axes p, q, from (x, y) >= 0; exact for a circle.
double ellipseDistance(double x, double y, double p, double q) {
  if (p == q) return std::hypot(x, y) - p;
  const double level = std::hypot(x / p, y / q), slope = std::hypot(x / (p * p), y / (q * q));
  return slope > 0 ? level * (level - 1) / slope : -std::min(p, q);
}

}  // namespace

StrutDistance::StrutDistance(const StrutSegment& segment)
    : middle_(0.5 * (segment.a + segment.b)),
      radial_(segment.radial),
      halfWidth_(segment.width / 2),
      halfThickness_(segment.thickness / 2),
      round_(segment.round),
      openA_(segment.openA),
      openB_(segment.openB) {
  const double length = segment.length();
  sphere_ = length == 0 && round_;
  halfLength_ = length / 2 + segment.overlap;
  along_ = length > 0 ? Vec3((segment.b - segment.a) / length) : Vec3(Vec3::UnitZ());
  across_ = along_.cross(radial_);
}

double StrutDistance::operator()(const Vec3& point) const {
  const Vec3 offset = point - middle_;
  if (sphere_) return offset.norm() - halfWidth_;

  const double place = offset.dot(along_);
  double s = std::abs(place) - halfLength_;
  if (s < 0 && !(place > 0 ? openB_ : openA_)) s = -std::numeric_limits<double>::infinity();
  const double w = std::abs(offset.dot(across_)), h = std::abs(offset.dot(radial_));
  if (round_) {
    const double section = ellipseDistance(w, h, halfWidth_, halfThickness_);
    return std::hypot(std::max(s, 0.0), std::max(section, 0.0)) + std::min(std::max(s, section), 0.0);
  }
  const Vec3 q(s, w - halfWidth_, h - halfThickness_);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

Vec3 Stent::centre(std::size_t n) const {
  const StrutSphere& sphere = spheres[n];
  const StrutSegment& segment = segments[sphere.segment];
  const Cylindrical a = toCylindrical(segment.a), b = toCylindrical(segment.b);
  const double turn = std::remainder(b.angle - a.angle, 2 * std::numbers::pi);
  const double radius = a.radius + sphere.along * (b.radius - a.radius);
  const double around = radius * turn, axial = b.z - a.z, length = std::hypot(around, axial);
  const double acrossAround = length > 0 ? -axial / length : 0,
               acrossAxial = length > 0 ? around / length : 0;
  return toCartesian({radius + sphere.outward,
                      a.angle + sphere.along * turn + sphere.across * acrossAround / radius,
                      a.z + sphere.along * axial + sphere.across * acrossAxial});
}

std::vector<Vec3> Stent::middles() const {
  constexpr double spacing = 20e-6;  // [m]; well below the width of a strut
  std::vector<Vec3> places;
  for (const StrutSegment& segment : segments) {
    const int steps = 1 + static_cast<int>(segment.length() / spacing);
    for (int k = 0; k <= steps; ++k)
      places.push_back(segment.a + (segment.b - segment.a) * (static_cast<double>(k) / steps));
  }
  return places;
}

Stent Stent::movedOutwards(double distance) const {
  Stent moved = *this;
  for (StrutSegment& segment : moved.segments) {
    segment.a = atRadius(segment.a, radiusOf(segment.a) + distance);
    segment.b = atRadius(segment.b, radiusOf(segment.b) + distance);
  }
  return moved;
}

}  // namespace restenosis
