#include "bridge/flow/lbm/LatticeSampler.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

std::size_t boxIndex(const d3q19::Step& size, int x, int y, int z) {
  return (static_cast<std::size_t>(x) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(size[2]) +
         static_cast<std::size_t>(z);
}

}  // namespace

LatticeSampler::LatticeSampler(const SteadyLattice& solved) : frame_(solved.lattice().frame) {
  const auto& size = frame_.size;
  index_.assign(boxIndex(size, size[0] - 1, size[1] - 1, size[2] - 1) + 1, -1);
  points_.reserve(solved.nodes());
  for (const NodeRun& run : solved.lattice().layout.runs())
    for (std::uint32_t n = 0; n < run.count; ++n) {
      index_[boxIndex(size, run.x, run.y, run.z + static_cast<int>(n))] =
          static_cast<std::int32_t>(points_.size());
      points_.push_back(solved.at(run.first + n));
    }
}

FlowPoint LatticeSampler::operator()(const Vec3& position) const {
  const Vec3 where = (position - frame_.origin) / frame_.dx;
  FlowPoint result;
  double fluidWeight = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    d3q19::Step node{};
    for (int d = 0; d < 3; ++d) {
      const bool upper = (corner >> d) & 1;
      // Beyond the first and last layer the flow goes on as in it
      const double last = frame_.size[static_cast<std::size_t>(d)] - 1;
      const double x = d == 2 ? std::clamp(where[d], 0.0, last) : where[d];
      const double low = std::min(std::floor(x), d == 2 ? std::max(0.0, last - 1.0) : std::floor(x));
      weight *= upper ? x - low : 1.0 - (x - low);
      node[static_cast<std::size_t>(d)] = static_cast<int>(low) + (upper ? 1 : 0);
    }
    if (weight <= 0.0) continue;
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d) inside = inside && node[d] >= 0 && node[d] < frame_.size[d];
    if (!inside) continue;
    const std::int32_t at = index_[boxIndex(frame_.size, node[0], node[1], node[2])];
    if (at < 0) continue;
    const FlowPoint& point = points_[static_cast<std::size_t>(at)];
    result.velocity += weight * point.velocity;
    result.pressure += weight * point.pressure;
    fluidWeight += weight;
  }
  if (fluidWeight > 0.0) result.pressure /= fluidWeight;
  return result;
}

}  // namespace restenosis
