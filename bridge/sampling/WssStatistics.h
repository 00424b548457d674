#pragma once

#include <span>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// Area-weighted statistics of the wall shear stress over some faces. All zero for no faces.
struct WssStatistics {
  double area = 0;                     ///< [m^2]
  double mean = 0;                     ///< [Pa]
  double p5 = 0, median = 0, p95 = 0;  ///< least stress that 5, 50, 95 % of the area do not exceed [Pa]
  double lowAreaFraction = 0;          ///< share of the area below the threshold
};

/// Stress [Pa] at which the nitric oxide of model 7 reaches 0.001 nmol/mm^3, the threshold of arrest.
inline constexpr double lowWss = 0.273;

/// Statistics of one region, wall or strut. `threshold` [Pa] bounds low stress.
WssStatistics wssStatistics(std::span<const WallFace> faces, SurfaceRegion region, double threshold = lowWss);

}  // namespace restenosis
