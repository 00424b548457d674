#include "bridge/flow/EndClearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/flow/LumenShape.h"
#include "bridge/surface/Rotation.h"
#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

/// How far the wall may lean away from the end, sideways over upwards: 60 degrees.
const double lean = std::sqrt(3.0);
/// What the cone about the rim is widened by, over the depth looked at.
constexpr double widening = 0.5;

using Place2 = Eigen::Vector2d;

/// An end in its own plane.
class EndOutline {
 public:
  EndOutline(const TriSurface& lumen, SurfaceRegion end) {
    const EndPlane plane = endPlane(lumen, end);
    turn_ = rotationOnto(-plane.normal, Vec3::UnitZ());
    centre_ = plane.centre;
    for (const auto& [from, to] : endRim(lumen, end))
      edges_.push_back({within(lumen.vertices[from]).head<2>(), within(lumen.vertices[to]).head<2>()});
  }

  /// In the end's frame: z is the height over its plane, into the lumen.
  Vec3 within(const Vec3& place) const { return turn_ * (place - centre_); }
  Vec3 back(const Vec3& inFrame) const { return turn_.transpose() * inFrame + centre_; }

  /// How far beside the end a place of its plane lies [m]; 0 within it.
  double beside(const Place2& p) const {
    bool inside = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : edges_) {
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
      const Place2 edge = b - a;
      const double square = edge.squaredNorm();
      const double share = square > 0.0 ? std::clamp((p - a).dot(edge) / square, 0.0, 1.0) : 0.0;
      nearest = std::min(nearest, (p - a - share * edge).squaredNorm());
    }
    return inside ? 0.0 : std::sqrt(nearest);
  }

 private:
  struct Edge {
    Place2 from, to;
  };
  Eigen::Matrix3d turn_;
  Vec3 centre_;
  std::vector<Edge> edges_;
};

/// The part of a polygon with side * z <= limit.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double side, double limit) {
  std::vector<Vec3> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double over = side * a.z() - limit, overNext = side * b.z() - limit;
    if (over <= 0.0) kept.push_back(a);
    if ((over <= 0.0) != (overNext <= 0.0)) kept.push_back(a + over / (over - overNext) * (b - a));
  }
  return kept;
}

/// The triangles near the plane of an end, cut off `depth` from it.
class EndSlab {
 public:
  EndSlab(const TriSurface& lumen, SurfaceRegion end, double depth)
      : lumen_(lumen), end_(end), depth_(depth), outline_(lumen, end) {
    heights_.reserve(lumen.vertices.size());
    for (const Vec3& v : lumen.vertices) heights_.push_back(outline_.within(v).z());
  }

  bool reachedBy(std::size_t triangle) const {
    const auto& t = lumen_.triangles[triangle];
    const auto [low, high] = std::minmax({heights_[t[0]], heights_[t[1]], heights_[t[2]]});
    return lumen_.region[triangle] != end_ && low <= depth_ && high >= -depth_;
  }
  bool reachedBySide(std::size_t triangle, int side) const {
    const auto& t = lumen_.triangles[triangle];
    return std::min(heights_[t[side]], heights_[t[(side + 1) % 3]]) <= depth_;
  }
  /// Whether what is near of a triangle stays within the cone about the rim.
  bool byTheRim(std::size_t triangle) const {
    return std::ranges::all_of(near(triangle), [&](const Vec3& p) {
      return outline_.beside(p.head<2>()) <= lean * std::max(0.0, p.z()) + widening * depth_;
    });
  }
  /// A place of a triangle beside the end, if any: what lies over it is not in the way.
  std::optional<Vec3> placeBeside(std::size_t triangle) const {
    for (const Vec3& p : near(triangle))
      if (outline_.beside(p.head<2>()) > 0.0) return outline_.back(p);
    return std::nullopt;
  }

 private:
  std::vector<Vec3> near(std::size_t triangle) const {
    std::vector<Vec3> corners;
    for (const auto v : lumen_.triangles[triangle]) corners.push_back(outline_.within(lumen_.vertices[v]));
    return clipped(clipped(corners, 1.0, depth_), -1.0, depth_);
  }

  const TriSurface& lumen_;
  SurfaceRegion end_;
  double depth_;
  EndOutline outline_;
  std::vector<double> heights_;
};

/// The end's own wall: from its rim on, within the slab and by the rim.
std::vector<bool> ownWall(const TriSurface& lumen, SurfaceRegion end, const EndSlab& slab) {
  const SurfaceEdges edges = surfaceEdges(lumen);
  std::vector<bool> own(lumen.triangles.size(), false);
  std::vector<std::uint32_t> reached;
  const auto visit = [&](std::uint32_t triangle) {
    if (triangle == SurfaceEdges::none || own[triangle] || !slab.reachedBy(triangle)) return;
    const SurfaceRegion region = lumen.region[triangle];
    if (isEnd(region) || !slab.byTheRim(triangle)) return;
    own[triangle] = true;
    reached.push_back(triangle);
  };
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end)
      for (const auto beyond : edges.beyond[t]) visit(beyond);
  while (!reached.empty()) {
    const std::uint32_t triangle = reached.back();
    reached.pop_back();
    for (int side = 0; side < 3; ++side)
      if (slab.reachedBySide(triangle, side)) visit(edges.beyond[triangle][side]);
  }
  return own;
}

}  // namespace

std::optional<Vec3> strangerNearEnd(const TriSurface& lumen, SurfaceRegion end, double depth) {
  const EndSlab slab(lumen, end, depth);
  const std::vector<bool> own = ownWall(lumen, end, slab);
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (!own[t] && slab.reachedBy(t))
      if (const auto place = slab.placeBeside(t)) return place;
  return std::nullopt;
}

}  // namespace restenosis
