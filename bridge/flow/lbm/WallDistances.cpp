#include "bridge/flow/lbm/WallDistances.h"

namespace restenosis {
namespace {

constexpr double notWanted = -1.0;

std::unique_ptr<NearestTriangle> wallOf(const TriSurface& lumen) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i)
    if (lumen.region[i] == SurfaceRegion::wall || lumen.region[i] == SurfaceRegion::strut)
      triangles.push_back(lumen.triangles[i]);
  return std::make_unique<NearestTriangle>(lumen.vertices, std::move(triangles));
}

}  // namespace

WallDistances::WallDistances(const TriSurface& lumen, const LumenLattice& lattice)
    : lumen_(lumen), lattice_(lattice), distance_(lattice.layout.places(), notWanted) {}

void WallDistances::add(const Vec3& centre, const std::vector<NearNode>& nodes) {
  for (const NearNode& n : nodes) {
    if (distance_[n.place] != notWanted) continue;
    distance_[n.place] = 0.0;
    wanted_.push_back({n.place, Vec3(centre + lattice_.frame.dx * n.offset)});
  }
}

void WallDistances::find() {
  if (wanted_.empty()) return;
  if (!wall_) wall_ = wallOf(lumen_);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t k = 0; k < wanted_.size(); ++k)
    distance_[wanted_[k].place] = wall_->at(wanted_[k].position).distance / lattice_.frame.dx;
  wanted_.clear();
}

void WallDistances::set(std::vector<NearNode>& nodes) const {
  for (NearNode& n : nodes) n.wallDistance = distance_[n.place];
}

}  // namespace restenosis
