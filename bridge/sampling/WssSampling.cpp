#include "bridge/sampling/WssSampling.h"

#include <algorithm>

#include "bridge/surface/PointTree.h"

namespace restenosis {
namespace {

/// The wall's agents, found by the distance to their surfaces.
class WallAgents {
 public:
  explicit WallAgents(const AgentStore& agents)
      : agents_(agents), cells_(wallAgents(agents)), tree_(centresOf(agents, cells_)) {
    for (const Index i : cells_) largest_ = std::max(largest_, agents.radius[i]);
  }
  const std::vector<Index>& cells() const { return cells_; }

  Index nearestTo(const Vec3& point) const {
    const PointTree::Near nearest = tree_.nearest(point, 1).front();
    Index best = cells_[nearest.index];
    double bestDistance = nearest.distance - agents_.radius[best];
    // A cell with a nearer surface has its centre at most this far away.
    const double reach = bestDistance + largest_ * (1 + 1e-9);
    for (const auto& candidate : tree_.within(point, reach)) {
      const Index cell = cells_[candidate.index];
      const double distance = candidate.distance - agents_.radius[cell];
      if (distance < bestDistance || (distance == bestDistance && agents_.id[cell] < agents_.id[best]))
        best = cell, bestDistance = distance;
    }
    return best;
  }

 private:
  static std::vector<Index> wallAgents(const AgentStore& agents) {
    std::vector<Index> cells;
    for (Index i = 0; i < agents.size(); ++i)
      if (agents.kind[i] != AgentKind::strut) cells.push_back(i);
    return cells;
  }
  static std::vector<Vec3> centresOf(const AgentStore& agents, const std::vector<Index>& cells) {
    std::vector<Vec3> centres;
    for (const Index i : cells) centres.push_back(agents.position(i));
    return centres;
  }

  const AgentStore& agents_;
  std::vector<Index> cells_;
  PointTree tree_;
  double largest_ = 0;
};

}  // namespace

CellShear sampleWss(const AgentStore& agents, std::span<const WallFace> faces) {
  CellShear shear;
  shear.wss.assign(agents.size(), 0.0);
  shear.area.assign(agents.size(), 0.0);
  const WallAgents wallAgents(agents);
  std::vector<Vec3> centres;
  std::vector<std::size_t> wall;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].region != SurfaceRegion::wall) continue;
    wall.push_back(f);
    centres.push_back(faces[f].centre);
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

  const PointTree tree(std::move(centres));
  for (const Index cell : wallAgents.cells()) {
    if (shear.area[cell] > 0) {
      shear.wss[cell] /= shear.area[cell];
      continue;
    }
    if (!agents.has(cell, AgentFlag::exposed)) continue;
    const std::size_t nearest = tree.nearest(agents.position(cell), 1).front().index;
    shear.wss[cell] = faces[wall[nearest]].traction.norm();
    ++shear.cellsFilled;
  }
  return shear;
}

}  // namespace restenosis
