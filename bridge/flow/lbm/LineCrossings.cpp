#include "bridge/flow/lbm/LineCrossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace restenosis {
namespace {

struct Projected {
  double p, q, t;
};

/// On which side of the edge from vertex a to b the point lies: +1 or -1, never 0, and opposite for the edge
/// from b to a. A point on the edge counts as moved by (e, e^2) with an infinitesimal e.
int side(const Projected& pa, const Projected& pb, std::uint32_t a, std::uint32_t b, double p, double q) {
  if (a > b) return -side(pb, pa, b, a, p, q);
  const double dp = pb.p - pa.p, dq = pb.q - pa.q;
  const double area = dp * (q - pa.q) - dq * (p - pa.p);
  if (area != 0.0) return area > 0.0 ? 1 : -1;
  if (dq != 0.0) return dq < 0.0 ? 1 : -1;
  return dp > 0.0 ? 1 : -1;
}

/// Where the line through (p, q) meets the plane of the triangle, within the triangle's own range: a triangle
/// seen nearly edge-on has no other sure answer.
double depth(const std::array<Projected, 3>& v, double p, double q) {
  const auto [low, high] = std::minmax({v[0].t, v[1].t, v[2].t});
  const double ap = v[1].p - v[0].p, aq = v[1].q - v[0].q, bp = v[2].p - v[0].p, bq = v[2].q - v[0].q;
  const double determinant = ap * bq - aq * bp;
  if (determinant == 0.0) return 0.5 * (low + high);
  const double a = ((p - v[0].p) * bq - (q - v[0].q) * bp) / determinant;
  const double b = (ap * (q - v[0].q) - aq * (p - v[0].p)) / determinant;
  const double t = v[0].t + a * (v[1].t - v[0].t) + b * (v[2].t - v[0].t);
  return std::isfinite(t) ? std::clamp(t, low, high) : 0.5 * (low + high);
}

}  // namespace

LinesAlong::LinesAlong(const d3q19::Step& along) : direction(along), leading(0) {
  while (leading < 2 && direction[leading] == 0) ++leading;
  second = (leading + 1) % 3;
  third = (leading + 2) % 3;
}

std::vector<SurfaceCrossing> crossings(std::span<const Vec3> vertices,
                                       std::span<const std::array<std::uint32_t, 3>> triangles,
                                       const d3q19::Step& direction) {
  const LinesAlong lines(direction);
  std::vector<Projected> projected;
  projected.reserve(vertices.size());
  for (const Vec3& v : vertices) {
    const double t = v[static_cast<int>(lines.leading)];
    projected.push_back({v[static_cast<int>(lines.second)] - t * direction[lines.second],
                         v[static_cast<int>(lines.third)] - t * direction[lines.third], t});
  }
  std::vector<SurfaceCrossing> found;
  for (std::uint32_t n = 0; n < triangles.size(); ++n) {
    const auto& id = triangles[n];
    const std::array<Projected, 3> v{projected[id[0]], projected[id[1]], projected[id[2]]};
    const auto [pLow, pHigh] = std::minmax({v[0].p, v[1].p, v[2].p});
    const auto [qLow, qHigh] = std::minmax({v[0].q, v[1].q, v[2].q});
    for (auto p = static_cast<std::int32_t>(std::ceil(pLow)); p <= pHigh; ++p)
      for (auto q = static_cast<std::int32_t>(std::ceil(qLow)); q <= qHigh; ++q) {
        const int first = side(v[0], v[1], id[0], id[1], p, q);
        if (side(v[1], v[2], id[1], id[2], p, q) != first || side(v[2], v[0], id[2], id[0], p, q) != first)
          continue;
        found.push_back({p, q, depth(v, p, q), n});
      }
  }
  std::sort(found.begin(), found.end(), [](const SurfaceCrossing& a, const SurfaceCrossing& b) {
    return std::tie(a.p, a.q, a.t, a.triangle) < std::tie(b.p, b.q, b.t, b.triangle);
  });
  return found;
}

}  // namespace restenosis
