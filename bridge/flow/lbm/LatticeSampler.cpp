#include "bridge/flow/lbm/LatticeSampler.h"

#include <algorithm>
#include <cmath>

namespace restenosis {

FlowPoint LatticeSampler::operator()(const Vec3& position) const {
  const Vec3 where = (position - field_.frame.origin) / field_.frame.dx;
  FlowPoint result;
  double fluidWeight = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    d3q19::Step node{};
    for (int d = 0; d < 3; ++d) {
      const bool upper = (corner >> d) & 1;
      // Beyond the first and last layer the flow goes on as in it
      const double last = field_.frame.size[static_cast<std::size_t>(d)] - 1;
      const double x = d == 2 ? std::clamp(where[d], 0.0, last) : where[d];
      const double low = std::min(std::floor(x), d == 2 ? std::max(0.0, last - 1.0) : std::floor(x));
      weight *= upper ? x - low : 1.0 - (x - low);
      node[static_cast<std::size_t>(d)] = static_cast<int>(low) + (upper ? 1 : 0);
    }
    if (weight <= 0.0) continue;
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d) inside = inside && node[d] >= 0 && node[d] < field_.frame.size[d];
    if (!inside) continue;
    const std::int32_t at = field_.index[field_.at(node)];
    if (at < 0) continue;
    const FlowPoint& point = field_.points[static_cast<std::size_t>(at)];
    result.velocity += weight * point.velocity;
    result.pressure += weight * point.pressure;
    fluidWeight += weight;
  }
  if (fluidWeight > 0.0) result.pressure /= fluidWeight;
  return result;
}

}  // namespace restenosis
