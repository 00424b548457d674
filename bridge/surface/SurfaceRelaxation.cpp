#include "bridge/surface/SurfaceRelaxation.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace restenosis {
namespace {

/// Vertex neighbours in compressed rows, in the fixed order of the triangles. A vertex on a rim (between cap
/// and wall) has only its neighbours along the rim.
struct Neighbours {
  enum Place : std::uint8_t { onWall = 1, onCap = 2, onRim = 3 };
  std::vector<std::uint8_t> place;
  std::vector<std::uint32_t> start, member;

  explicit Neighbours(const TriSurface& s) : place(s.vertices.size(), 0), start(s.vertices.size() + 1, 0) {
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
      for (const auto v : s.triangles[t]) place[v] |= isEnd(s.region[t]) ? onCap : onWall;
    // In a closed surface every edge is met once in each direction, so directed edges list each neighbour
    // once.
    forEach(s, [&](std::uint32_t from, std::uint32_t) { ++start[from + 1]; });
    for (std::size_t v = 0; v < s.vertices.size(); ++v) start[v + 1] += start[v];
    member.resize(start.back());
    auto next = start;
    forEach(s, [&](std::uint32_t from, std::uint32_t to) { member[next[from]++] = to; });
  }

 private:
  template <class F>
  void forEach(const TriSurface& s, F&& f) const {
    for (const auto& t : s.triangles)
      for (int c = 0; c < 3; ++c) {
        const auto from = t[c], to = t[(c + 1) % 3];
        if (place[from] != onRim || place[to] == onRim) f(from, to);
      }
  }
};

/// One or two Newton steps onto the isosurface along the gradient, within the plane if `planar`; no step is
/// longer than half a spacing.
Vec3 project(const BandField& field, Vec3 p, bool planar) {
  for (int step = 0; step < 2; ++step) {
    Vec3 gradient;
    const double value = field.at(p, gradient);
    if (planar) gradient.z() = 0;
    const double slope = gradient.squaredNorm();
    if (slope < 1e-4) break;
    Vec3 move = -value / slope * gradient;
    const double longest = 0.5 * field.grid().spacing;
    if (move.norm() > longest) move *= longest / move.norm();
    p += move;
  }
  return p;
}

/// Least ratio of a triangle's double area to its longest side squared that a pass may leave behind.
constexpr double leastShape = 0.02;
/// Least cosine between a triangle's normals before and after a pass.
constexpr double leastTurn = 0.5;

bool spoiled(const Vec3& before, const Vec3 (&p)[3]) {
  const Vec3 after = (p[1] - p[0]).cross(p[2] - p[0]);
  const double longest =
      std::max({(p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm()});
  return after.dot(before) < leastTurn * after.norm() * before.norm() || after.norm() < leastShape * longest;
}

}  // namespace

void relaxSurface(TriSurface& s, const BandField& field, int passes) {
  const Neighbours neighbours(s);
  std::vector<Vec3> moved(s.vertices.size());
  std::vector<std::uint8_t> undo(s.vertices.size());
  for (int pass = 0; pass < passes; ++pass) {
#pragma omp parallel for schedule(static)
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
      Vec3 mean = Vec3::Zero();
      const auto first = neighbours.start[v], last = neighbours.start[v + 1];
      for (auto n = first; n < last; ++n) mean += s.vertices[neighbours.member[n]];
      if (first == last) {
        moved[v] = s.vertices[v];
        continue;
      }
      Vec3 p = 0.5 * (s.vertices[v] + mean / static_cast<double>(last - first));
      const auto place = neighbours.place[v];
      if (place != Neighbours::onCap) p = project(field, p, place == Neighbours::onRim);
      if (place != Neighbours::onWall) {
        p.z() = s.vertices[v].z();
      } else {
        // The clearance of wall vertices from the ends keeps the caps the only triangles in their plane.
        const double clearance = 0.05 * field.grid().spacingZ;
        p.z() = std::clamp(p.z(), std::min(s.vertices[v].z(), clearance),
                           std::max(s.vertices[v].z(), field.grid().length - clearance));
      }
      moved[v] = p;
    }
    // Undoing a vertex changes its other triangles, so look again until nothing is spoiled that was not so.
    bool again = true;
    while (again) {
      again = false;
      std::fill(undo.begin(), undo.end(), 0);
#pragma omp parallel for schedule(static) reduction(|| : again)
      for (std::size_t n = 0; n < s.triangles.size(); ++n) {
        const auto& t = s.triangles[n];
        const Vec3 before = (s.vertices[t[1]] - s.vertices[t[0]]).cross(s.vertices[t[2]] - s.vertices[t[0]]);
        const Vec3 after[3] = {moved[t[0]], moved[t[1]], moved[t[2]]};
        if (!spoiled(before, after)) continue;
        for (const auto v : t) {
          if (moved[v] == s.vertices[v]) continue;
          std::atomic_ref(undo[v]).store(1, std::memory_order_relaxed);
          again = true;
        }
      }
      if (!again) break;
#pragma omp parallel for schedule(static)
      for (std::size_t v = 0; v < undo.size(); ++v)
        if (undo[v]) moved[v] = s.vertices[v];
    }
    s.vertices.swap(moved);
  }
}

}  // namespace restenosis
