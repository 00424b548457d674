#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

using Triangle = std::array<Vec3, 3>;

namespace detail {

/// Calls f(centre, area) for the slices of a triangle across its longest edge, corners[0] to corners[1],
/// none of them thicker than `longest`.
template <class F>
void forEachSlice(const Triangle& corners, double height, double longest, F&& f) {
  const Vec3& start = corners[0];
  const double length = (corners[1] - start).norm();
  const Vec3 along = (corners[1] - start) / length;
  const double top = std::clamp(along.dot(corners[2] - start), 0.0, length);
  const Vec3 up = (corners[2] - start - top * along) / height;
  const auto heightAt = [&](double x) {
    return height * (x <= top ? (top > 0 ? x / top : 1.0) : (length - x) / (length - top));
  };
  const auto sliceUp = [&](double from, double to) {
    const int slices = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
    for (int k = 0; k < slices; ++k) {
      const double thick = (to - from) / slices, x = from + k * thick;
      const double a = heightAt(x), b = heightAt(x + thick);
      if (!(a + b > 0)) continue;
      const double middle = x + thick * (a + 2 * b) / (3 * (a + b));
      const double above = (a * a + a * b + b * b) / (3 * (a + b));
      f(Vec3(start + middle * along + above * up), 0.5 * (a + b) * thick);
    }
  };
  if (top > 0) sliceUp(0, top);
  if (top < length) sliceUp(top, length);
}

}  // namespace detail

/// Calls f(centre, area) for pieces of a triangle that together are all of it, none of them much longer than
/// `longest`: what is sampled once a piece is sampled evenly, however long and thin the triangle is. A
/// triangle with no edge longer than that is one piece. Lengths > 0, one unit.
template <class F>
void forEachPieceOf(Triangle corners, double longest, F&& f) {
  const auto edge = [&](int k) { return (corners[(k + 1) % 3] - corners[k]).norm(); };
  const double area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  const int first = edge(0) >= edge(1) && edge(0) >= edge(2) ? 0 : edge(1) >= edge(2) ? 1 : 2;
  if (edge(first) <= longest) return f(Vec3((corners[0] + corners[1] + corners[2]) / 3.0), area);
  std::rotate(corners.begin(), corners.begin() + first, corners.end());
  const double height = 2 * area / edge(0);
  if (height <= longest) return detail::forEachSlice(corners, height, longest, f);
  const Triangle middles{0.5 * (corners[0] + corners[1]), 0.5 * (corners[1] + corners[2]),
                         0.5 * (corners[2] + corners[0])};
  for (int k = 0; k < 3; ++k) forEachPieceOf({corners[k], middles[k], middles[(k + 2) % 3]}, longest, f);
  forEachPieceOf(middles, longest, f);
}

}  // namespace restenosis
