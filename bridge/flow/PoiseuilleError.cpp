#include "bridge/flow/PoiseuilleError.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/TubeFlow.h"

namespace restenosis {
namespace {

/// See PoiseuilleError::endMargin.
constexpr double leastMargin = 0.1e-3, usualDiameter = 1.8e-3;

}  // namespace

std::optional<PoiseuilleError> poiseuilleError(std::span<const WallFace> faces, double diameter,
                                               double length, const FlowConditions& conditions) {
  PoiseuilleError error;
  const double radius = 0.5 * diameter;
  error.endMargin = leastMargin * std::max(1.0, diameter / usualDiameter);
  error.exact = developedWallStress(conditions, conditions.flowRate, radius);
  double area = 0.0, sum = 0.0, squares = 0.0;
  for (const WallFace& face : faces) {
    const double z = face.centre.z();
    if (z < error.endMargin || z > length - error.endMargin) continue;
    const double relative = face.traction.norm() / error.exact - 1.0;
    area += face.area;
    sum += face.area * relative;
    squares += face.area * relative * relative;
    error.largest = std::max(error.largest, std::abs(relative));
  }
  if (!(area > 0.0)) return std::nullopt;
  error.mean = sum / area, error.l2 = std::sqrt(squares / area);
  return error;
}

}  // namespace restenosis
