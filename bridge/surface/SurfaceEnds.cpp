#include "bridge/surface/SurfaceEnds.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace restenosis {
namespace {

constexpr double degree = std::numbers::pi / 180;
/// How far the triangles of a cap may be from its plane: their normals, and their vertices over the cap's
/// reach (assumed; STL files keep seven digits).
constexpr double capAngle = 2 * degree, capDeparture = 1e-4;
constexpr double rimAngle = 30 * degree;
/// Part of a rim's length along which a hole's surface goes on in its plane.
constexpr double flushPart = 0.1;
/// Area of a hole without width, a crack, over that of the circle of its length.
constexpr double crackArea = 1e-3;

struct Side {
  std::uint64_t edge;
  std::uint32_t triangle;
  std::uint8_t side;
  bool forward;
};

std::vector<Side> sortedSides(const TriSurface& s) {
  std::vector<Side> sides;
  sides.reserve(3 * s.triangles.size());
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint64_t a = s.triangles[t][k], b = s.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b) << 32 | std::max(a, b), t, k, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  return sides;
}

/// Connected triangles in the plane of one of them.
class PlanarPatch {
 public:
  PlanarPatch(const TriSurface& surface, const SurfaceEdges& edges, std::uint32_t seed, double reach)
      : surface_(surface),
        edges_(edges),
        normal_(surface.areaVector(seed).normalized()),
        origin_(surface.centre(seed)),
        departure_(capDeparture * reach) {}

  bool holds(std::uint32_t triangle) const {
    for (const auto v : surface_.triangles[triangle])
      if (std::abs(normal_.dot(surface_.vertices[v] - origin_)) > departure_) return false;
    const Vec3 areaVector = surface_.areaVector(triangle);
    return areaVector.dot(normal_) >= std::cos(capAngle) * areaVector.norm();
  }

  /// Whether the surface turns inwards at this side by a rim's angle.
  bool sharpAndConvex(std::uint32_t triangle, int side) const {
    const std::uint32_t other = edges_.beyond[triangle][side];
    if (other == SurfaceEdges::none) return false;
    const auto& corners = surface_.triangles[other];
    double below = 0.0;  // the corner of the other triangle that is not on the edge
    for (const auto v : corners) {
      const double height = normal_.dot(surface_.vertices[v] - origin_);
      if (std::abs(height) > std::abs(below)) below = height;
    }
    const Vec3 areaVector = surface_.areaVector(other);
    return below < 0.0 && areaVector.dot(normal_) <= std::cos(rimAngle) * areaVector.norm();
  }

 private:
  const TriSurface& surface_;
  const SurfaceEdges& edges_;
  Vec3 normal_, origin_;
  double departure_;
};

}  // namespace

SurfaceEdges surfaceEdges(const TriSurface& surface) {
  SurfaceEdges edges;
  edges.beyond.assign(surface.triangles.size(), {SurfaceEdges::none, SurfaceEdges::none, SurfaceEdges::none});
  const auto sides = sortedSides(surface);
  for (std::size_t first = 0, last; first < sides.size(); first = last) {
    for (last = first; last < sides.size() && sides[last].edge == sides[first].edge;) ++last;
    const Side& a = sides[first];
    if (last - first == 1) {
      const auto& t = surface.triangles[a.triangle];
      edges.open.push_back({t[a.side], t[(a.side + 1) % 3]});
    } else if (last - first == 2) {
      const Side& b = sides[first + 1];
      edges.beyond[a.triangle][a.side] = b.triangle;
      edges.beyond[b.triangle][b.side] = a.triangle;
      if (a.forward == b.forward) ++edges.opposed;
    } else {
      ++edges.crowded;
      const auto& t = surface.triangles[a.triangle];
      edges.crowdedEdges.push_back({t[a.side], t[(a.side + 1) % 3]});
    }
  }
  return edges;
}

std::vector<std::vector<std::uint32_t>> openRims(const std::vector<OpenEdge>& open) {
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : open) next.emplace(from, to);
  std::vector<std::vector<std::uint32_t>> rims;
  while (!next.empty()) {
    std::vector<std::uint32_t> chain{next.begin()->first};
    std::map<std::uint32_t, std::size_t> place{{chain.front(), 0}};
    do {
      const auto edge = next.find(chain.back());
      if (edge == next.end()) throw std::runtime_error("an open rim does not close");
      const std::uint32_t to = edge->second;
      next.erase(edge);
      if (const auto met = place.find(to); met != place.end()) {
        const auto first = chain.begin() + static_cast<std::ptrdiff_t>(met->second);
        rims.emplace_back(first, chain.end());
        for (auto v = first + 1; v != chain.end(); ++v) place.erase(*v);
        chain.erase(first + 1, chain.end());
      } else {
        place.emplace(to, chain.size());
        chain.push_back(to);
      }
    } while (chain.size() > 1);
  }
  return rims;
}

std::vector<bool> holesAmong(const TriSurface& surface, const SurfaceEdges& edges,
                             const std::vector<std::vector<std::uint32_t>>& rims) {
  std::map<OpenEdge, std::uint32_t> beside;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (edges.beyond[t][k] == SurfaceEdges::none)
        beside.emplace(OpenEdge{surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]}, t);
  std::vector<bool> holes;
  for (const auto& rim : rims) {
    const auto edgeFrom = [&](std::size_t k) { return OpenEdge{rim[k], rim[(k + 1) % rim.size()]}; };
    Vec3 areaVector = Vec3::Zero();  // of a cap that is oriented as the surface
    double length = 0.0, flush = 0.0;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const Vec3 a = surface.vertices[edgeFrom(k)[0]] - surface.vertices[rim[0]],
                 b = surface.vertices[edgeFrom(k)[1]] - surface.vertices[rim[0]];
      areaVector += 0.5 * b.cross(a);
      length += (b - a).norm();
    }
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const Vec3 other = surface.areaVector(beside.at(edgeFrom(k)));
      if (other.dot(areaVector) > std::cos(rimAngle) * other.norm() * areaVector.norm())
        flush += (surface.vertices[edgeFrom(k)[1]] - surface.vertices[edgeFrom(k)[0]]).norm();
    }
    const double circle = length * length / (4.0 * std::numbers::pi);
    holes.push_back(flush > flushPart * length || areaVector.norm() < crackArea * circle);
  }
  return holes;
}

FittedPlane fitPlane(const TriSurface& surface, const std::vector<std::uint32_t>& vertices) {
  FittedPlane plane;
  for (const auto v : vertices) plane.centre += surface.vertices[v] / static_cast<double>(vertices.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto v : vertices) {
    const Vec3 d = surface.vertices[v] - plane.centre;
    spread += d * d.transpose();
  }
  // Eigenvalues come in increasing order: the first direction is the one of least spread
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  for (const auto v : vertices)
    plane.departure =
        std::max(plane.departure, std::abs(plane.normal.dot(surface.vertices[v] - plane.centre)));
  return plane;
}

std::vector<std::vector<std::uint32_t>> planarCaps(const TriSurface& surface, const SurfaceEdges& edges) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : surface.vertices) box.extend(v);
  const double reach = box.diagonal().norm();
  std::vector<std::uint32_t> bySize(surface.triangles.size());
  std::vector<double> area(surface.triangles.size());
  for (std::uint32_t t = 0; t < bySize.size(); ++t) bySize[t] = t, area[t] = surface.areaVector(t).norm();
  // Large triangles first: their planes are the best defined
  std::stable_sort(bySize.begin(), bySize.end(), [&](auto a, auto b) { return area[a] > area[b]; });

  std::vector<std::uint32_t> patchOf(surface.triangles.size(), SurfaceEdges::none);
  std::vector<std::vector<std::uint32_t>> caps;
  for (const std::uint32_t seed : bySize) {
    if (patchOf[seed] != SurfaceEdges::none || !(area[seed] > 0.0)) continue;
    const PlanarPatch patch(surface, edges, seed, reach);
    std::vector<std::uint32_t> members{seed};
    patchOf[seed] = seed;
    bool cap = true;
    for (std::size_t n = 0; n < members.size(); ++n)
      for (int side = 0; side < 3; ++side) {
        const std::uint32_t other = edges.beyond[members[n]][side];
        if (other != SurfaceEdges::none && patchOf[other] == seed) continue;
        if (other != SurfaceEdges::none && patchOf[other] == SurfaceEdges::none && patch.holds(other)) {
          members.push_back(other);
          patchOf[other] = seed;
        } else if (!patch.sharpAndConvex(members[n], side)) {
          cap = false;
        }
      }
    if (cap) caps.push_back(std::move(members));
  }
  return caps;
}

}  // namespace restenosis
