#include "bridge/compare/ProbeLines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bridge/flow/LumenShape.h"

namespace restenosis {
namespace {

struct Section {
  Eigen::Vector2d centre;
  double radius;  ///< of the circle of equal area
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> contour;
};

/// The contour in which a plane of constant z cuts the surface, its area and centroid by Green's theorem.
Section section(const TriSurface& lumen, double z) {
  Section s{Eigen::Vector2d::Zero(), 0.0, {}};
  for (const auto& t : lumen.triangles) {
    std::vector<Eigen::Vector2d> cut(2);
    int entering = 0, leaving = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = lumen.vertices[t[k]], &b = lumen.vertices[t[(k + 1) % 3]];
      const bool aboveA = a.z() >= z, aboveB = b.z() >= z;
      if (aboveA == aboveB) continue;
      const double share = (z - a.z()) / (b.z() - a.z());
      cut[aboveB ? 0 : 1] = a.head<2>() + share * (b - a).head<2>();
      ++(aboveB ? entering : leaving);
    }
    if (entering == 1 && leaving == 1) s.contour.emplace_back(cut[0], cut[1]);
  }
  double area = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (const auto& [a, b] : s.contour) {
    const double twice = a.x() * b.y() - a.y() * b.x();
    area += 0.5 * twice;
    moment += twice / 6.0 * (a + b);
  }
  if (area == 0.0) return s;
  s.centre = moment / area;
  s.radius = std::sqrt(std::abs(area) / std::numbers::pi);
  return s;
}

/// Whether a point lies within the contour, further than `clearance` [m] from it.
bool wellInside(const Section& s, const Eigen::Vector2d& p, double clearance) {
  bool inside = false;
  for (const auto& [a, b] : s.contour) {
    const Eigen::Vector2d along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    if ((p - a - share * along).norm() < clearance) return false;
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<Vec3> ProbeLines::points() const {
  std::vector<Vec3> all = axis;
  for (const Plane& plane : planes) all.insert(all.end(), plane.points.begin(), plane.points.end());
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

ProbeLines probeLines(const TriSurface& lumen, const ProbeSettings& settings) {
  const double first = lumenEnd(lumen, SurfaceRegion::inlet).z,
               length = lumenEnd(lumen, SurfaceRegion::outlet).z - first;
  ProbeLines lines;
  for (int i = 0; i < settings.axisPoints; ++i) {
    const double z = first + (i + 0.5) / settings.axisPoints * length;
    const Section s = section(lumen, z);
    lines.axis.push_back({s.centre.x(), s.centre.y(), z});
  }
  for (int i = 0; i < settings.planes; ++i) {
    ProbeLines::Plane plane{first + (i + 0.5) / settings.planes * length, {}, 0.0};
    const Section s = section(lumen, plane.z);
    Eigen::Vector2d low = s.centre, high = s.centre;
    for (const auto& [a, b] : s.contour) low = low.cwiseMin(a), high = high.cwiseMax(a);
    plane.spacing = (high - low).maxCoeff() / settings.acrossPlane;
    for (int ix = 0; ix < settings.acrossPlane; ++ix)
      for (int iy = 0; iy < settings.acrossPlane; ++iy) {
        const Eigen::Vector2d p = low + plane.spacing * Eigen::Vector2d(ix + 0.5, iy + 0.5);
        if (wellInside(s, p, settings.clearance * s.radius)) plane.points.push_back({p.x(), p.y(), plane.z});
      }
    lines.planes.push_back(std::move(plane));
  }
  return lines;
}

}  // namespace restenosis
