#include "bridge/flow/lbm/LatticeUnits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bridge/flow/LumenShape.h"

namespace restenosis {

using std::numbers::pi;

namespace {
constexpr double largestRelaxationTime = 2.0;
}

FlowEstimate::FlowEstimate(const TriSurface& lumen, const FlowConditions& conditions, int stations) {
  if (!liesAlongZ(lumen)) {
    fromEnds(lumen, conditions);
    return;
  }
  const LumenEnd inlet = lumenEnd(lumen, SurfaceRegion::inlet);
  length_ = lumenEnd(lumen, SurfaceRegion::outlet).z - inlet.z;
  centre_ = inlet.centre;
  spacing_ = length_ / stations;
  first_ = inlet.z + 0.5 * spacing_;
  std::vector<double> z;
  for (int i = 0; i < stations; ++i) z.push_back(first_ + i * spacing_);
  area_ = crossSectionAreas(lumen, z);
  const auto narrowest = std::min_element(area_.begin(), area_.end());
  if (!(*narrowest > 0.0))
    throw std::invalid_argument(fmt::format("the lumen is closed at z = {:.4g} mm",
                                            1e3 * z[static_cast<std::size_t>(narrowest - area_.begin())]));
  // Drop along each slice for a unit flow rate
  pressure_.assign(area_.size(), 0.0);
  double resistance = 0.0;
  for (std::size_t i = area_.size(); i-- > 0;) {
    const double slice = 8.0 * pi * conditions.dynamicViscosity() * spacing_ / (area_[i] * area_[i]);
    pressure_[i] = resistance + 0.5 * slice;
    resistance += slice;
  }
  flowRate_ = conditions.drive == FlowConditions::Drive::flowRate
                  ? conditions.flowRate
                  : conditions.pressureGradient * length_ / resistance;
  for (double& p : pressure_) p *= flowRate_;
  peak_ = 2.0 * flowRate_ / *narrowest;
}

void FlowEstimate::fromEnds(const TriSurface& lumen, const FlowConditions& conditions) {
  const double inlet = endPlane(lumen, SurfaceRegion::inlet).area,
               outlet = endPlane(lumen, SurfaceRegion::outlet).area;
  const double narrowest = std::min(inlet, outlet);
  length_ = enclosedVolume(lumen) / (0.5 * (inlet + outlet));
  flowRate_ =
      conditions.drive == FlowConditions::Drive::flowRate
          ? conditions.flowRate
          : conditions.pressureGradient * narrowest * narrowest / (8.0 * pi * conditions.dynamicViscosity());
  peak_ = 2.0 * flowRate_ / narrowest;
}

std::size_t FlowEstimate::station(double z) const {
  const double last = static_cast<double>(area_.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::round((z - first_) / spacing_), 0.0, last));
}

double FlowEstimate::pressure(const Vec3& position) const {
  return knowsEndsOnly() ? 0.0 : pressure_[station(position.z())];
}

double FlowEstimate::velocity(const Vec3& position) const {
  if (knowsEndsOnly()) return 0.0;
  const double area = area_[station(position.z())];
  const double square = (position - centre_).head<2>().squaredNorm() * pi / area;
  return 2.0 * flowRate_ / area * std::max(0.0, 1.0 - square);
}

LatticeUnits latticeUnits(double dx, const FlowEstimate& estimate, const FlowConditions& conditions,
                          double latticeVelocity) {
  const double byVelocity = latticeVelocity * dx / estimate.peakVelocity();
  const double byViscosity = (largestRelaxationTime - 0.5) * dx * dx / (3.0 * conditions.kinematicViscosity);
  return {dx, std::min(byVelocity, byViscosity), conditions.density};
}

}  // namespace restenosis
