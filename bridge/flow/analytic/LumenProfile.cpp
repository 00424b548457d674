#include "bridge/flow/analytic/LumenProfile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/LumenShape.h"

namespace restenosis {

using std::numbers::pi;

LumenProfile::LumenProfile(const TriSurface& lumen, int stations) {
  const double inlet = lumenEnd(lumen, SurfaceRegion::inlet).z;
  const double length = lumenEnd(lumen, SurfaceRegion::outlet).z - inlet;
  spacing_ = length / stations;
  first_ = inlet + 0.5 * spacing_;
  std::vector<double> z(stations);
  for (int i = 0; i < stations; ++i) z[i] = first_ + i * spacing_;
  const auto sections = crossSections(lumen, z);
  double meanArea = 0.0;
  for (int i = 0; i < stations; ++i) {
    if (!(sections[i].area > 0.0))
      throw FlowFailed(fmt::format("analytic flow: the lumen is closed at z = {:.4g} mm", z[i] * 1e3), {});
    meanArea += sections[i].area / stations;
  }
  // Compared before it becomes a whole number, which it may be too large for
  const double radii = std::sqrt(meanArea / pi) / spacing_;
  const int reach = radii < stations ? std::max(1, static_cast<int>(std::lround(radii))) : stations;
  for (int i = 0; i < stations; ++i) {
    const int from = std::max(0, i - reach), to = std::min(stations - 1, i + reach);
    const Vec3 axis = (sections[to].centre - sections[from].centre).normalized();
    places_.push_back({std::sqrt(sections[i].area * axis.z() / pi), axis});
  }
}

LumenProfile::Place LumenProfile::at(double z) const {
  const double last = static_cast<double>(places_.size() - 1);
  const double x = std::clamp((z - first_) / spacing_, 0.0, last);
  const auto i = std::min(static_cast<std::size_t>(x), places_.size() - 2);
  const double f = x - static_cast<double>(i);
  return {(1.0 - f) * places_[i].radius + f * places_[i + 1].radius,
          (1.0 - f) * places_[i].axis + f * places_[i + 1].axis};
}

double LumenProfile::meanRadius() const {
  double sum = 0.0;
  for (const Place& place : places_) sum += place.radius;
  return sum / static_cast<double>(places_.size());
}

double LumenProfile::resistance(double dynamicViscosity) const {
  double sum = 0.0;
  for (const Place& place : places_)
    sum += 8.0 * dynamicViscosity * spacing_ / (place.axis.z() * pi * std::pow(place.radius, 4));
  return sum;
}

}  // namespace restenosis
