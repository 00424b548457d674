#include "WallStress.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace restenosis {
namespace {

/// Nodes count up to this distance [spacings]; where there are too few for a fit, up to the larger one.
constexpr double radius = 3.5, largeRadius = 5.0;
/// Nodes below which no slope is fitted.
constexpr std::size_t fewestNodes = 6;
/// Weight of nodes with a link to the wall: their stress carries the error of the wall rule (first order), so
/// they only decide where there are no others.
constexpr double firstLayerWeight = 0.01;
/// Ridge on the slopes, relative to the sum of weights: decides where nodes lie in a plane.
constexpr double ridge = 1e-6;

/// Faces that meet at a larger angle than 45 degrees do not smooth each other's normals.
constexpr double creaseCosine = 0.7071;

struct NearNode {
  std::uint32_t place;
  Vec3 offset;  // from the face's centre [spacings]
  double weight;
};

/// Smoothed normals: of the faces around the vertices of each face, area-weighted, those beyond a crease left
/// out.
class SmoothNormals {
 public:
  explicit SmoothNormals(const TriSurface& s) : surface_(s), first_(s.vertices.size() + 1, 0) {
    forEachCorner([this](std::uint32_t vertex, std::uint32_t) { ++first_[vertex + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    faces_.resize(first_.back());
    auto next = first_;
    forEachCorner([&](std::uint32_t vertex, std::uint32_t face) { faces_[next[vertex]++] = face; });
  }
  Vec3 at(std::size_t face) const {
    const Vec3 own = surface_.areaVector(face).normalized();
    Vec3 sum = Vec3::Zero();
    for (const auto v : surface_.triangles[face])
      for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
        const Vec3 other = surface_.areaVector(faces_[k]);
        if (other.dot(own) > creaseCosine * other.norm()) sum += other;
      }
    return sum.normalized();
  }

 private:
  template <class F>
  void forEachCorner(F&& f) const {
    for (std::uint32_t i = 0; i < surface_.triangles.size(); ++i) {
      if (surface_.region[i] != SurfaceRegion::wall && surface_.region[i] != SurfaceRegion::strut) continue;
      for (const auto v : surface_.triangles[i]) f(v, i);
    }
  }
  const TriSurface& surface_;
  std::vector<std::uint32_t> first_, faces_;
};

class NodeFinder {
 public:
  explicit NodeFinder(const LumenLattice& lattice) : frame_(lattice.frame) {
    const auto& n = frame_.size;
    place_.assign(
        static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]),
        none);
    for (const NodeRun& run : lattice.layout.runs())
      for (std::uint32_t k = 0; k < run.count; ++k)
        place_[at(run.x, run.y, run.z + static_cast<int>(k))] = run.first + k;
    for (const auto& link : lattice.links) linked_.push_back(link.node);
    std::sort(linked_.begin(), linked_.end());
    linked_.erase(std::unique(linked_.begin(), linked_.end()), linked_.end());
  }

  /// Fluid nodes within `reach` spacings on the lumen's side of a face, in the order of the lattice.
  std::vector<NearNode> around(const Vec3& centre, const Vec3& normal, double reach) const {
    const Vec3 middle = (centre - frame_.origin) / frame_.dx;
    const auto low = [&](int d) { return std::max(0, static_cast<int>(std::ceil(middle[d] - reach))); };
    const auto high = [&](int d) {
      return std::min(frame_.size[static_cast<std::size_t>(d)] - 1,
                      static_cast<int>(std::floor(middle[d] + reach)));
    };
    std::vector<NearNode> found;
    for (int x = low(0); x <= high(0); ++x)
      for (int y = low(1); y <= high(1); ++y)
        for (int z = low(2); z <= high(2); ++z) {
          const Vec3 offset = Vec3(x, y, z) - middle;
          const double distance = offset.norm() / reach;
          if (distance >= 1.0 || offset.dot(normal) > 0.0) continue;
          const std::uint32_t place = place_[at(x, y, z)];
          if (place == none) continue;
          const bool first = std::binary_search(linked_.begin(), linked_.end(), place);
          found.push_back({place, offset, (first ? firstLayerWeight : 1.0) * (1.0 - distance * distance)});
        }
    return found;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(frame_.size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(frame_.size[2]) +
           static_cast<std::size_t>(z);
  }
  LatticeFrame frame_;
  std::vector<std::uint32_t> place_, linked_;
};

/// Turns weights of a fit into those of its value at the origin of the offsets.
void fitToOrigin(std::vector<NearNode>& nodes) {
  Eigen::Matrix4d normalMatrix = Eigen::Matrix4d::Zero();
  double total = 0.0;
  const auto row = [](const NearNode& n) {
    return Eigen::Vector4d(1.0, n.offset.x(), n.offset.y(), n.offset.z());
  };
  for (const NearNode& n : nodes) {
    normalMatrix += n.weight * row(n) * row(n).transpose();
    total += n.weight;
  }
  if (nodes.size() < fewestNodes) {
    for (NearNode& n : nodes) n.weight /= total;
    return;
  }
  normalMatrix.diagonal().tail<3>().array() += ridge * total;
  const Eigen::Vector4d value = normalMatrix.ldlt().solve(Eigen::Vector4d::Unit(0));
  for (NearNode& n : nodes) n.weight *= value.dot(row(n));
}

void keepNearest(std::vector<NearNode>& nodes) {
  const auto nearest = std::min_element(nodes.begin(), nodes.end(), [](const NearNode& a, const NearNode& b) {
    return a.offset.squaredNorm() < b.offset.squaredNorm();
  });
  nodes = {{nearest->place, nearest->offset, 1.0}};
}

}  // namespace

WallStress::WallStress(const TriSurface& lumen, const LumenLattice& lattice, StressRule rule) {
  const SmoothNormals normals(lumen);
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != SurfaceRegion::wall && lumen.region[i] != SurfaceRegion::strut) continue;
    const double area = lumen.areaVector(i).norm();
    if (!(area > 0.0)) continue;
    faces_.push_back({lumen.centre(i), normals.at(i), area, lumen.region[i], 0, 0});
  }

  const NodeFinder finder(lattice);
  std::vector<std::vector<NearNode>> found(faces_.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    auto nodes = finder.around(faces_[f].centre, faces_[f].normal, radius);
    if (nodes.size() < fewestNodes) nodes = finder.around(faces_[f].centre, faces_[f].normal, largeRadius);
    if (nodes.empty()) continue;
    if (rule == StressRule::nearest)
      keepNearest(nodes);
    else
      fitToOrigin(nodes);
    found[f] = std::move(nodes);
  }

  for (const auto& nodes : found)
    for (const auto& n : nodes) nodes_.push_back(n.place);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    faces_[f].first = static_cast<std::uint32_t>(terms_.size());
    faces_[f].count = static_cast<std::uint32_t>(found[f].size());
    if (found[f].empty()) ++bare_;
    for (const auto& n : found[f]) {
      const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), n.place) - nodes_.begin();
      terms_.push_back({static_cast<std::uint32_t>(at), n.weight});
    }
  }
}

Vec3 WallStress::traction(std::size_t face, const std::vector<std::array<double, 6>>& stress,
                          double pascal) const {
  const Face& f = faces_[face];
  std::array<double, 6> s{};
  for (std::uint32_t t = f.first; t < f.first + f.count; ++t)
    for (std::size_t k = 0; k < 6; ++k) s[k] += terms_[t].weight * stress[terms_[t].node][k];
  const Vec3& n = f.normal;
  const Vec3 onWall =
      -Vec3(s[0] * n.x() + s[3] * n.y() + s[4] * n.z(), s[3] * n.x() + s[1] * n.y() + s[5] * n.z(),
            s[4] * n.x() + s[5] * n.y() + s[2] * n.z());
  return pascal * (onWall - onWall.dot(n) * n);
}

std::vector<WallFace> WallStress::wall(const std::vector<std::array<double, 6>>& stress,
                                       double pascal) const {
  std::vector<WallFace> result;
  result.reserve(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    result.push_back({faces_[f].centre, faces_[f].area, traction(f, stress, pascal), faces_[f].region});
  return result;
}

std::vector<std::array<double, 6>> WallStress::stresses(const LatticeFlowBase& flow) const {
  std::vector<std::array<double, 6>> result(nodes_.size());
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < nodes_.size(); ++n) result[n] = flow.state(nodes_[n]).stress;
  return result;
}

}  // namespace restenosis
