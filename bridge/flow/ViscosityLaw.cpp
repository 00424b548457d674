#include "bridge/flow/ViscosityLaw.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

/// Of the shear rate at a stress, relative.
constexpr double rateTolerance = 1e-13;

}  // namespace

double ViscosityLaw::operator()(double shearRate) const {
  if (kind == Kind::carreau)
    return infiniteShear +
           (zeroShear - infiniteShear) * std::pow(1 + std::pow(time * shearRate, 2), (index - 1) / 2);
  // Infinite at rest, where the stress has not reached that of yield
  if (!(shearRate > 0)) return zeroShear;
  const double root = std::sqrt(yieldStress / shearRate) + std::sqrt(infiniteShear);
  return std::min(zeroShear, root * root);
}

double ViscosityLaw::shearRateAt(double stress) const {
  if (!(stress > 0)) return 0;
  // It thins, so it shears no slower than with the viscosity at rest, and no faster than with the least
  double low = stress / zeroShear, high = 2 * low;
  while ((*this)(high)*high < stress) high *= 2;
  while (high - low > rateTolerance * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    ((*this)(middle)*middle < stress ? low : high) = middle;
  }
  return high;
}

ViscosityLaw ViscosityLaw::in(double length, double unitTime) const {
  ViscosityLaw law = *this;
  const double viscosity = length * length / unitTime;
  law.zeroShear /= viscosity, law.infiniteShear /= viscosity;
  law.time /= unitTime;
  law.yieldStress /= viscosity / unitTime;
  return law;
}

}  // namespace restenosis
