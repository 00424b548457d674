#include "bridge/surface/NearestTriangle.h"

#include <algorithm>
#include <stdexcept>

namespace restenosis {
namespace {

std::vector<Vec3> centresOf(const std::vector<Vec3>& vertices,
                            const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (triangles.empty()) throw std::invalid_argument("there are no triangles to be near to");
  std::vector<Vec3> centres;
  centres.reserve(triangles.size());
  for (const auto& t : triangles)
    centres.emplace_back((vertices[t[0]] + vertices[t[1]] + vertices[t[2]]) / 3.0);
  return centres;
}

Vec3 onSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  return square > 0.0 ? Vec3(a + std::clamp((p - a).dot(along) / square, 0.0, 1.0) * along) : a;
}

}  // namespace

NearestTriangle::NearestTriangle(std::vector<Vec3> vertices,
                                 std::vector<std::array<std::uint32_t, 3>> triangles)
    : vertices_(std::move(vertices)),
      triangles_(std::move(triangles)),
      centres_(centresOf(vertices_, triangles_)) {
  reaches_.reserve(triangles_.size());
  for (const auto& t : triangles_) {
    const Vec3 centre = (vertices_[t[0]] + vertices_[t[1]] + vertices_[t[2]]) / 3.0;
    double reach = 0.0;
    for (const auto v : t) reach = std::max(reach, (vertices_[v] - centre).norm());
    reaches_.push_back(reach);
    reach_ = std::max(reach_, reach);
  }
}

Vec3 NearestTriangle::onTriangle(std::size_t triangle, const Vec3& p) const {
  const auto& [i, j, k] = triangles_[triangle];
  const Vec3 &a = vertices_[i], &b = vertices_[j], &c = vertices_[k];
  const Vec3 normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  if (square > 0.0) {
    // Barycentric coordinates of the foot of the perpendicular
    const double u = (c - b).cross(p - b).dot(normal), v = (a - c).cross(p - c).dot(normal),
                 w = (b - a).cross(p - a).dot(normal);
    if (u >= 0.0 && v >= 0.0 && w >= 0.0) return p - (p - a).dot(normal) / square * normal;
  }
  Vec3 best = onSegment(a, b, p);
  for (const Vec3& other : {onSegment(b, c, p), onSegment(c, a, p)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  return best;
}

NearestTriangle::Place NearestTriangle::at(const Vec3& point) const {
  const std::size_t first = centres_.nearest(point, 1).front().index;
  Place best{onTriangle(first, point), 0.0, first};
  best.distance = (best.point - point).norm();
  // A triangle that comes nearer has its centre at most this far away
  const double slack = 1.0 + 1e-9;
  for (const auto& near : centres_.within(point, (best.distance + reach_) * slack)) {
    if (near.distance > (best.distance + reaches_[near.index]) * slack) continue;
    const Vec3 place = onTriangle(near.index, point);
    if (const double distance = (place - point).norm(); distance < best.distance)
      best = {place, distance, near.index};
  }
  return best;
}

}  // namespace restenosis
