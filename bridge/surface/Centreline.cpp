#include "bridge/surface/Centreline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/Splines>
#include <utility>

#include "bridge/surface/Rotation.h"

namespace restenosis {
namespace {

/// Distance of the points that a curve is kept by (assumed: on a radius of 5 mm the chord is 1e-8 m off).
constexpr double curveSpacing = 20e-6;
/// Fewest of them.
constexpr std::size_t fewestOnCurve = 50;
/// Steps by which the foot of a perpendicular is found; each leaves a part of the distance over the radius of
/// curvature.
constexpr int mostFootSteps = 60;

std::size_t pointsFor(double length) {
  return std::max(fewestOnCurve, static_cast<std::size_t>(std::ceil(length / curveSpacing)) + 1);
}

/// Carries a vector across from one frame to the next by two reflections.
Vec3 carried(const Vec3& vector, const Vec3& from, const Vec3& fromTangent, const Vec3& to,
             const Vec3& toTangent) {
  const auto reflected = [](const Vec3& v, const Vec3& normal) -> Vec3 {
    return v - 2 * v.dot(normal) / normal.squaredNorm() * normal;
  };
  const Vec3 step = to - from;
  const Vec3 turn = toTangent - reflected(fromTangent, step);
  const Vec3 once = reflected(vector, step);
  return turn.squaredNorm() > 0 ? reflected(once, turn) : once;
}

}  // namespace

Centreline::Centreline(std::vector<Vec3> points, std::vector<Vec3> tangents, double firstPlace)
    : tree_(std::make_shared<const PointTree>(points)) {
  places_.push_back(firstPlace);
  const Eigen::Matrix3d turn = rotationOnto(Vec3::UnitZ(), tangents.front());
  frames_.push_back({points.front(), turn * Vec3::UnitX(), turn * Vec3::UnitY(), tangents.front()});
  for (std::size_t n = 1; n < points.size(); ++n) {
    const Frame& before = frames_.back();
    const Vec3 across = carried(before.x, before.origin, before.z, points[n], tangents[n]);
    const Vec3 x = (across - across.dot(tangents[n]) * tangents[n]).normalized();
    // Of an arc that touches both tangents the chord is shorter by the sine of half its angle over that half
    const double half = 0.5 * std::acos(std::clamp(before.z.dot(tangents[n]), -1.0, 1.0));
    const double chord = (points[n] - before.origin).norm();
    places_.push_back(places_.back() + (half > 1e-6 ? chord * half / std::sin(half) : chord));
    frames_.push_back({points[n], x, tangents[n].cross(x), tangents[n]});
  }
}

Centreline Centreline::through(const std::vector<Vec3>& points) {
  if (points.size() < 2) throw std::invalid_argument("a centreline needs at least two points");
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3Xd matrix(3, count);
  double chords = 0;
  for (Eigen::Index n = 0; n < count; ++n) {
    matrix.col(n) = points[n];
    if (n == 0) continue;
    const double chord = (points[n] - points[n - 1]).norm();
    if (!(chord > 0)) throw std::invalid_argument("two neighbours on a centreline lie in one place");
    chords += chord;
  }
  using Spline = Eigen::Spline<double, 3>;
  const Spline spline =
      Eigen::SplineFitting<Spline>::Interpolate(matrix, std::min<Eigen::Index>(3, count - 1));
  std::vector<Vec3> curve, tangents;
  const std::size_t samples = pointsFor(1.2 * chords);
  for (std::size_t n = 0; n < samples; ++n) {
    const auto derivatives = spline.derivatives(static_cast<double>(n) / static_cast<double>(samples - 1), 1);
    curve.emplace_back(derivatives.col(0));
    tangents.push_back(Vec3(derivatives.col(1)).normalized());
  }
  return {std::move(curve), std::move(tangents), 0};
}

Centreline Centreline::arc(double radius, double from, double to) {
  std::vector<Vec3> points, tangents;
  const std::size_t samples = pointsFor(to - from);
  for (std::size_t n = 0; n < samples; ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(samples - 1);
    const double angle = (from + share * (to - from)) / radius;
    points.emplace_back(0, radius * (1 - std::cos(angle)), radius * std::sin(angle));
    tangents.emplace_back(0, std::sin(angle), std::cos(angle));
  }
  return {std::move(points), std::move(tangents), from};
}

double Centreline::largestCurvature() const {
  double largest = 0;
  for (std::size_t n = 0; n + 1 < frames_.size(); ++n)
    largest = std::max(largest, (frames_[n + 1].z - frames_[n].z).norm() / (places_[n + 1] - places_[n]));
  return largest;
}

Centreline::Frame Centreline::at(double place) const {
  const auto beyond = [](const Frame& end, double distance) {
    return Frame{end.origin + distance * end.z, end.x, end.y, end.z};
  };
  if (place <= places_.front()) return beyond(frames_.front(), place - places_.front());
  if (place >= places_.back()) return beyond(frames_.back(), place - places_.back());
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(places_, place) - places_.begin());
  const Frame &a = frames_[next - 1], &b = frames_[next];
  const double step = places_[next] - places_[next - 1], share = (place - places_[next - 1]) / step;
  Frame frame;
  // Hermite's cubic: it keeps the tangents
  const double t = share, t2 = t * t, t3 = t2 * t;
  frame.origin = (2 * t3 - 3 * t2 + 1) * a.origin + (t3 - 2 * t2 + t) * step * a.z +
                 (3 * t2 - 2 * t3) * b.origin + (t3 - t2) * step * b.z;
  frame.z = (a.z + share * (b.z - a.z)).normalized();
  const Vec3 x = a.x + share * (b.x - a.x);
  frame.x = (x - x.dot(frame.z) * frame.z).normalized();
  frame.y = frame.z.cross(frame.x);
  return frame;
}

Vec3 Centreline::toBent(const Vec3& straight) const {
  const Frame frame = at(straight.z());
  return frame.origin + straight.x() * frame.x + straight.y() * frame.y;
}

Vec3 Centreline::toStraight(const Vec3& bent) const {
  double place = places_[tree_->nearest(bent, 1).front().index];
  Frame frame = at(place);
  for (int n = 0; n < mostFootSteps; ++n) {
    const double ahead = (bent - frame.origin).dot(frame.z);
    place += ahead;
    frame = at(place);
    if (std::abs(ahead) < 1e-15 + 1e-14 * length()) break;
  }
  const Vec3 across = bent - frame.origin;
  return {across.dot(frame.x), across.dot(frame.y), place};
}

Vec3 Centreline::vectorToBent(const Vec3& straight, const Vec3& vector) const {
  const Frame frame = at(straight.z());
  return vector.x() * frame.x + vector.y() * frame.y + vector.z() * frame.z;
}

Vec3 Centreline::vectorToStraight(const Vec3& straight, const Vec3& vector) const {
  const Frame frame = at(straight.z());
  return {vector.dot(frame.x), vector.dot(frame.y), vector.dot(frame.z)};
}

}  // namespace restenosis
