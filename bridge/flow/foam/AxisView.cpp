#include "bridge/flow/foam/AxisView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "bridge/flow/LumenShape.h"

namespace restenosis {
namespace {

constexpr double unseen = std::numeric_limits<double>::infinity();
/// The first and the last plane are cut so far from the ends, over the distance of planes: on them, the
/// triangles of the sides and of the ends meet.
constexpr double fromEnds = 1e-3;

/// Where an edge meets a plane of constant z; the same for either of its directions.
Vec3 onPlane(const TriSurface& lumen, std::uint32_t from, std::uint32_t to, double z) {
  const Vec3 &a = lumen.vertices[std::min(from, to)], &b = lumen.vertices[std::max(from, to)];
  return a + (z - a.z()) / (b.z() - a.z()) * (b - a);
}

double cross(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }

/// What the rays of one plane meet.
class RaysOfPlane {
 public:
  explicit RaysOfPlane(int angles) : nearest_(angles, unseen), hits_(angles, 0) {}

  /// A piece of the wall, from the axis. A ray along its end belongs to the piece that goes on from there.
  void add(Vec3 a, Vec3 b) {
    double turn = cross(a, b);
    if (turn < 0.0) std::swap(a, b), turn = -turn;
    if (!(turn > 0.0)) return;  // seen edge on
    const double step = 2.0 * std::numbers::pi / static_cast<double>(nearest_.size());
    const double begin = std::atan2(a.y(), a.x()), width = std::atan2(turn, a.x() * b.x() + a.y() * b.y());
    const auto first = static_cast<long>(std::floor(begin / step)) - 1;
    const auto last = static_cast<long>(std::ceil((begin + width) / step)) + 1;
    for (long i = first; i <= last; ++i) {
      const auto n = static_cast<long>(nearest_.size());
      const auto at = static_cast<std::size_t>(((i % n) + n) % n);
      const double angle = static_cast<double>(at) * step;
      const Vec3 ray(std::cos(angle), std::sin(angle), 0.0);
      // The same expression for either end, so that rounding puts a ray into one of two pieces that meet
      const double before = cross(a, ray), behind = cross(b, ray);
      if (before < 0.0 || behind >= 0.0 || ray.dot(a + b) <= 0.0) continue;
      const double distance = ray.dot(a + before / (before - behind) * (b - a));
      nearest_[at] = std::min(nearest_[at], distance);
      ++hits_[at];
    }
  }
  double nearest(std::size_t angle) const { return nearest_[angle]; }
  int hits(std::size_t angle) const { return hits_[angle]; }

 private:
  std::vector<double> nearest_;
  std::vector<int> hits_;
};

}  // namespace

AxisView::AxisView(const TriSurface& lumen, int planes, int angles)
    : planes_(planes),
      angles_(angles),
      inlet_(lumenEnd(lumen, SurfaceRegion::inlet).centre),
      outlet_(lumenEnd(lumen, SurfaceRegion::outlet).centre),
      radius_(static_cast<std::size_t>(planes + 1) * static_cast<std::size_t>(angles)) {
  const double step = (outlet_.z() - inlet_.z()) / planes;
  const auto cutAt = [&](int plane) {
    const double from = plane == 0 ? fromEnds : plane == planes_ ? planes_ - fromEnds : plane;
    return inlet_.z() + from * step;
  };
  std::vector<std::vector<std::uint32_t>> met(static_cast<std::size_t>(planes + 1));
  for (std::uint32_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != SurfaceRegion::wall && lumen.region[t] != SurfaceRegion::strut) continue;
    double low = unseen, high = -unseen;
    for (const auto v : lumen.triangles[t]) {
      low = std::min(low, lumen.vertices[v].z());
      high = std::max(high, lumen.vertices[v].z());
    }
    const auto place = [&](double z) { return (z - inlet_.z()) / step; };
    const int first = std::max(0, static_cast<int>(std::floor(place(low))));
    const int last = std::min(planes_, static_cast<int>(std::ceil(place(high))));
    for (int plane = first; plane <= last; ++plane)
      if (low < cutAt(plane) && high >= cutAt(plane)) met[static_cast<std::size_t>(plane)].push_back(t);
  }
  std::size_t again = 0;
  bool outside = false;
#pragma omp parallel for schedule(dynamic) reduction(+ : again) reduction(|| : outside)
  for (int plane = 0; plane <= planes_; ++plane) {
    const double z = cutAt(plane);
    const Vec3 centre = axis(plane);
    RaysOfPlane rays(angles_);
    for (const std::uint32_t t : met[static_cast<std::size_t>(plane)]) {
      std::array<Vec3, 2> ends;
      std::size_t found = 0;
      for (std::size_t k = 0; k < 3 && found < 2; ++k) {
        const std::uint32_t from = lumen.triangles[t][k], to = lumen.triangles[t][(k + 1) % 3];
        if ((lumen.vertices[from].z() < z) == (lumen.vertices[to].z() < z)) continue;
        ends[found++] = onPlane(lumen, from, to, z) - centre;
      }
      if (found == 2) rays.add(ends[0], ends[1]);
    }
    for (int a = 0; a < angles_; ++a) {
      const auto ray = static_cast<std::size_t>(a);
      radius_[index(plane, a)] = rays.nearest(ray);
      again += rays.hits(ray) > 1 ? 1 : 0;
      outside = outside || rays.hits(ray) % 2 == 0;
    }
  }
  if (outside)
    throw std::invalid_argument("the line between the centres of the lumen's ends leaves the lumen");
  undercut_ = static_cast<double>(again) / static_cast<double>(radius_.size());
}

Vec3 AxisView::axis(int plane) const {
  return inlet_ + static_cast<double>(plane) / planes_ * (outlet_ - inlet_);
}

}  // namespace restenosis
