#include "WssSampling.h"

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>

namespace restenosis {
namespace {

struct PointCloud {
  std::vector<Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t n, std::size_t axis) const { return points[n][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>, PointCloud, 3>;

/// The wall's agents, found by the distance to their surfaces.
class WallAgents {
 public:
  explicit WallAgents(const AgentStore& agents) : agents_(agents) {
    for (Index i = 0; i < agents.size(); ++i) {
      if (agents.kind[i] == AgentKind::strut) continue;
      cells_.push_back(i);
      cloud_.points.push_back(agents.position(i));
      largest_ = std::max(largest_, agents.radius[i]);
    }
    tree_.buildIndex();
  }
  const std::vector<Index>& cells() const { return cells_; }

  Index nearestTo(const Vec3& point) const {
    std::uint32_t nearestCentre = 0;
    double squared = 0;
    tree_.knnSearch(point.data(), 1, &nearestCentre, &squared);
    // A cell with a nearer surface has its centre at most this far away.
    const double reach = std::sqrt(squared) - agents_.radius[cells_[nearestCentre]] + largest_ * (1 + 1e-9);
    std::vector<std::pair<std::uint32_t, double>> candidates;
    tree_.radiusSearch(point.data(), reach * reach, candidates, nanoflann::SearchParams());
    Index best = cells_[nearestCentre];
    double bestDistance = std::sqrt(squared) - agents_.radius[best];
    for (const auto& [n, squaredDistance] : candidates) {
      const Index cell = cells_[n];
      const double distance = std::sqrt(squaredDistance) - agents_.radius[cell];
      if (distance < bestDistance || (distance == bestDistance && agents_.id[cell] < agents_.id[best]))
        best = cell, bestDistance = distance;
    }
    return best;
  }

 private:
  const AgentStore& agents_;
  std::vector<Index> cells_;
  PointCloud cloud_;
  KdTree tree_{3, cloud_};
  double largest_ = 0;
};

}  // namespace

CellShear sampleWss(const AgentStore& agents, std::span<const WallFace> faces) {
  CellShear shear;
  shear.wss.assign(agents.size(), 0.0);
  shear.area.assign(agents.size(), 0.0);
  const WallAgents wallAgents(agents);
  PointCloud centres;
  std::vector<std::size_t> wall;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].region != SurfaceRegion::wall) continue;
    wall.push_back(f);
    centres.points.push_back(faces[f].centre);
  }
  if (wallAgents.cells().empty() || wall.empty()) return shear;

  std::vector<Index> owner(wall.size());
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < wall.size(); ++n) owner[n] = wallAgents.nearestTo(faces[wall[n]].centre);
  for (std::size_t n = 0; n < wall.size(); ++n) {
    const WallFace& face = faces[wall[n]];
    shear.wss[owner[n]] += face.area * face.traction.norm();
    shear.area[owner[n]] += face.area;
  }
  shear.facesGiven = wall.size();

  KdTree tree(3, centres);
  tree.buildIndex();
  for (const Index cell : wallAgents.cells()) {
    if (shear.area[cell] > 0) {
      shear.wss[cell] /= shear.area[cell];
      continue;
    }
    if (!agents.has(cell, AgentFlag::exposed)) continue;
    const Vec3 centre = agents.position(cell);
    std::uint32_t nearest = 0;
    double squared = 0;
    tree.knnSearch(centre.data(), 1, &nearest, &squared);
    shear.wss[cell] = faces[wall[nearest]].traction.norm();
    ++shear.cellsFilled;
  }
  return shear;
}

}  // namespace restenosis
