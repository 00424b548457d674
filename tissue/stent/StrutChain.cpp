#include "tissue/stent/StrutChain.h"

#include <algorithm>
#include <cmath>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

constexpr double largestSagitta = 0.1e-6;  // [m]

/// Overlap of the ends of two segments with directions `before` and `after` [m]; a little even when straight,
/// so that rounding opens no gap.
double overlapAt(const Vec3& before, const Vec3& after, double extent) {
  const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
  return extent * std::clamp(0.5 * std::tan(std::min(turn, 2.0) / 2), 0.005, 0.5);
}

}  // namespace

double longestSegment(double radius) { return std::sqrt(8 * radius * largestSagitta); }

void appendChain(std::vector<StrutSegment>& segments, std::span<const SurfacePoint> points,
                 const StentParameters& stent, const StentLayout& layout) {
  const double radius = layout.outerRadius - stent.strutThickness / 2;
  const std::size_t first = segments.size();
  for (std::size_t n = 0; n + 1 < points.size(); ++n) {
    const Vec3 a = toCartesian({radius, points[n].angle, points[n].z});
    const Vec3 b = toCartesian({radius, points[n + 1].angle, points[n + 1].z});
    segments.push_back({.a = a,
                        .b = b,
                        .radial = radialAt(0.5 * (a + b)),
                        .width = stent.strutWidth,
                        .thickness = stent.strutThickness,
                        .round = stent.strutShape == "round"});
  }
  const std::size_t count = segments.size() - first;
  const double extent = std::max(stent.strutWidth, stent.strutThickness);
  const bool closed = count > 2 && (segments.back().b - segments[first].a).norm() < 1e-6 * extent;
  const auto direction = [&](std::size_t n) -> Vec3 {
    const StrutSegment& segment = segments[first + n % count];
    return segment.b - segment.a;
  };
  for (std::size_t n = 0; n < count; ++n) {
    StrutSegment& segment = segments[first + n];
    segment.openA = !closed && n == 0;
    segment.openB = !closed && n + 1 == count;
    if (!segment.openA) segment.overlap = overlapAt(direction(n + count - 1), direction(n), extent);
    if (!segment.openB) {
      segment.overlap = std::max(segment.overlap, overlapAt(direction(n), direction(n + 1), extent));
    }
  }
}

void appendRing(std::vector<StrutSegment>& segments, double z0, double amplitude, std::int64_t waves,
                double phase, const StentParameters& stent, const StentLayout& layout) {
  const double steepest = std::hypot(layout.outerRadius, amplitude * static_cast<double>(waves));
  const int count = std::max(
      12, static_cast<int>(std::ceil(2 * std::numbers::pi * steepest / longestSegment(layout.outerRadius))));
  std::vector<SurfacePoint> points;
  for (int n = 0; n <= count; ++n) {
    const double angle = 2 * std::numbers::pi * n / count;
    points.push_back({angle, z0 + amplitude * std::sin(static_cast<double>(waves) * angle + phase)});
  }
  appendChain(segments, points, stent, layout);
}

void appendLine(std::vector<StrutSegment>& segments, const SurfacePoint& from, const SurfacePoint& to,
                const StentParameters& stent, const StentLayout& layout) {
  const double length = std::hypot((to.angle - from.angle) * layout.outerRadius, to.z - from.z);
  const int count = std::max(1, static_cast<int>(std::ceil(length / longestSegment(layout.outerRadius))));
  std::vector<SurfacePoint> points;
  for (int n = 0; n <= count; ++n) {
    const double t = static_cast<double>(n) / count;
    points.push_back({from.angle + t * (to.angle - from.angle), from.z + t * (to.z - from.z)});
  }
  appendChain(segments, points, stent, layout);
}

std::vector<double> ringPlaces(std::int64_t count, double halfExtent, const StentParameters& stent,
                               const StentLayout& layout) {
  const double middle = layout.vesselLength / 2;
  if (count == 1) return {middle};
  const double reach = stent.length / 2 - halfExtent;
  std::vector<double> places;
  for (std::int64_t k = 0; k < count; ++k) {
    places.push_back(middle + reach * (2.0 * static_cast<double>(k) / static_cast<double>(count - 1) - 1));
  }
  return places;
}

}  // namespace restenosis
