#include "bridge/flow/lbm/InletLayer.h"

#include <array>
#include <set>
#include <utility>

namespace restenosis {

using d3q19::Step;

InletLayer::InletLayer(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region)
    : size_(lattice.frame.size),
      layer_(lattice.frame.inletLayer),
      nodes_(static_cast<std::size_t>(size_[0] * size_[1]), solid) {
  for (const NodeRun& run : lattice.layout.runs())
    if (run.z <= layer_ && layer_ < run.z + static_cast<int>(run.count))
      nodes_[at(run.x, run.y)] = lattice.frame.alongZ ? joined : fluid;
  if (lattice.frame.alongZ) return;
  std::vector<Step> next;
  for (const SurfaceLink& link : lattice.links)
    if (link.coordinates[2] == layer_ && region[link.triangle] == SurfaceRegion::inlet &&
        d3q19::c[link.direction] == Step{0, 0, -1})
      next.push_back(link.coordinates);
  spread(lattice, std::move(next));
}

void InletLayer::spread(const LumenLattice& lattice, std::vector<Step> from) {
  std::set<std::pair<std::size_t, std::uint8_t>> cut;
  for (const SurfaceLink& link : lattice.links)
    if (link.coordinates[2] == layer_)
      cut.emplace(at(link.coordinates[0], link.coordinates[1]), link.direction);
  for (const Step& node : from) nodes_[at(node[0], node[1])] = joined;
  while (!from.empty()) {
    const Step node = from.back();
    from.pop_back();
    for (std::uint8_t direction = 1; direction < d3q19::directions; ++direction) {
      const Step& c = d3q19::c[direction];
      const int x = node[0] + c[0], y = node[1] + c[1];
      if (c[2] != 0 || x < 0 || y < 0 || x >= size_[0] || y >= size_[1] || nodes_[at(x, y)] != fluid ||
          cut.contains({at(node[0], node[1]), direction}))
        continue;
      nodes_[at(x, y)] = joined;
      from.push_back({x, y, layer_});
    }
  }
}

}  // namespace restenosis
