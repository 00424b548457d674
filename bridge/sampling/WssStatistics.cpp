#include "bridge/sampling/WssStatistics.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace restenosis {

WssStatistics wssStatistics(std::span<const WallFace> faces, SurfaceRegion region, double threshold) {
  WssStatistics s;
  std::vector<std::pair<double, double>> samples;  // stress, area
  for (const WallFace& f : faces) {
    if (f.region != region || !(f.area > 0)) continue;
    samples.emplace_back(f.traction.norm(), f.area);
    s.area += f.area;
  }
  if (samples.empty()) return s;
  std::sort(samples.begin(), samples.end());
  const std::pair<double, double*> wanted[] = {{0.05, &s.p5}, {0.5, &s.median}, {0.95, &s.p95}};
  std::size_t next = 0;
  double below = 0, low = 0;
  for (const auto& [stress, area] : samples) {
    below += area;
    s.mean += stress * area / s.area;
    if (stress < threshold) low += area;
    // The slack keeps the rounding of the sums from passing over a rank.
    while (next < 3 && below >= wanted[next].first * s.area * (1 - 1e-12)) *wanted[next++].second = stress;
  }
  s.lowAreaFraction = low / below;  // both in this order, so that all of it is 1
  return s;
}

}  // namespace restenosis
