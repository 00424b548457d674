#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/FlowBackend.h"
#include "tests/support/Constants.h"

namespace restenosis::support {

/// The thesis vessel: radius 0.9 mm, mean velocity 0.133 m/s.
inline constexpr double meanVelocity = 0.133;

inline FlowConditions vesselConditions() {
  return {.drive = FlowConditions::Drive::flowRate,
          .flowRate = meanVelocity * std::numbers::pi * vesselRadius * vesselRadius,
          .pressureGradient = 8.0 * 2.7e-3 * meanVelocity / (vesselRadius * vesselRadius),
          .density = 1000.0,
          .kinematicViscosity = 2.7e-6};
}
/// 4 mu U / R [Pa]
inline double vesselStress() { return 4.0 * 2.7e-3 * meanVelocity / vesselRadius; }

/// Area-weighted mean of the stress on wall and struts [Pa].
inline double meanStress(const FlowSolution& solution) {
  double sum = 0.0, area = 0.0;
  for (const WallFace& f : solution.wall) sum += f.area * f.traction.norm(), area += f.area;
  return sum / area;
}

/// Departure of the traction's magnitude from the expected one on the faces from `zLow` to `zHigh`,
/// area-weighted and relative to `scale`.
struct StressError {
  double mean = 0.0, l2 = 0.0, maximum = 0.0;
};
template <class Expected>
StressError stressError(const FlowSolution& solution, const Expected& expected, double scale, double zLow,
                        double zHigh) {
  StressError e;
  double area = 0.0;
  for (const WallFace& f : solution.wall) {
    if (f.region != SurfaceRegion::wall || f.centre.z() < zLow || f.centre.z() > zHigh) continue;
    const double error = (f.traction.norm() - expected(f.centre)) / scale;
    area += f.area;
    e.mean += f.area * error;
    e.l2 += f.area * error * error;
    e.maximum = std::max(e.maximum, std::abs(error));
  }
  e.mean /= area;
  e.l2 = std::sqrt(e.l2 / area);
  return e;
}
/// The same where one stress is expected everywhere.
inline StressError stressError(const FlowSolution& solution, double expected, double zLow, double zHigh) {
  return stressError(
      solution, [expected](const Vec3&) { return expected; }, expected, zLow, zHigh);
}

}  // namespace restenosis::support
