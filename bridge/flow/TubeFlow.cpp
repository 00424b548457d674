#include "bridge/flow/TubeFlow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace restenosis {
namespace {

/// Intervals from the axis to the wall, and the power by which they are shorter near the axis, where the law
/// bends: with them the flow rate of a Casson fluid is good to 1e-6.
constexpr int intervals = 2000;
constexpr double crowding = 3;
/// Of the shear rate at the wall, relative.
constexpr double precision = 1e-12;

/// Shear rates from 0 to that at the wall.
std::vector<double> ratesUpTo(double wall) {
  std::vector<double> rates;
  rates.reserve(intervals + 1);
  for (int n = 0; n <= intervals; ++n)
    rates.push_back(wall * std::pow(static_cast<double>(n) / intervals, crowding));
  return rates;
}

/// Flow rate over pi R^3, the integral by Simpson's rule in each interval.
double flowAt(const ViscosityLaw& law, double wallRate) {
  const double stress = law(wallRate) * wallRate;
  const auto cube = [&](double g) {
    const double t = law(g) * g / stress;
    return t * t * t;
  };
  const std::vector<double> rates = ratesUpTo(wallRate);
  double sum = 0;
  for (std::size_t n = 0; n + 1 < rates.size(); ++n) {
    const double a = rates[n], b = rates[n + 1];
    sum += (b - a) / 6 * (cube(a) + 4 * cube(0.5 * (a + b)) + cube(b));
  }
  return (wallRate - sum) / 3;
}

}  // namespace

TubeFlow TubeFlow::ofFlowRate(const ViscosityLaw& law, double flowRate, double radius) {
  const double wanted = flowRate / (std::numbers::pi * radius * radius * radius);
  // 4 of it without thinning, more with it
  double low = 3 * wanted, high = 4 * wanted;
  while (flowAt(law, high) < wanted) high *= 2;
  while (high - low > precision * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (flowAt(law, middle) < wanted ? low : high) = middle;
  }
  return {law, high, radius};
}

TubeFlow TubeFlow::ofWallStress(const ViscosityLaw& law, double stress, double radius) {
  return {law, law.shearRateAt(stress), radius};
}

TubeFlow::TubeFlow(const ViscosityLaw& law, double wallShearRate, double radius)
    : radius_(radius),
      flowRate_(std::numbers::pi * radius * radius * radius * flowAt(law, wallShearRate)),
      rates_(ratesUpTo(wallShearRate)) {
  for (const double g : rates_) stresses_.push_back(law(g) * g);
  velocities_.assign(rates_.size(), 0);
  for (std::size_t n = rates_.size() - 1; n-- > 0;) {
    const double rate = 0.5 * (rates_[n] + rates_[n + 1]);
    velocities_[n] =
        velocities_[n + 1] + rate * radius * (stresses_[n + 1] - stresses_[n]) / stresses_.back();
  }
}

double TubeFlow::velocity(double r) const {
  const double stress = std::clamp(r / radius_, 0.0, 1.0) * stresses_.back();
  const auto above = std::upper_bound(stresses_.begin(), stresses_.end(), stress);
  if (above == stresses_.end()) return velocities_.back();
  const auto n = static_cast<std::size_t>(above - stresses_.begin());
  const double share = (stress - stresses_[n - 1]) / (stresses_[n] - stresses_[n - 1]);
  return velocities_[n - 1] + share * (velocities_[n] - velocities_[n - 1]);
}

double developedWallStress(const FlowConditions& conditions, double flowRate, double radius) {
  if (conditions.thinning)
    return conditions.density * TubeFlow::ofFlowRate(*conditions.thinning, flowRate, radius).wallStress();
  return 4.0 * conditions.dynamicViscosity() * flowRate / (std::numbers::pi * radius * radius * radius);
}

double developedGradient(const FlowConditions& conditions, double flowRate, double area) {
  if (conditions.thinning) {
    const double radius = std::sqrt(area / std::numbers::pi);
    return 2.0 * developedWallStress(conditions, flowRate, radius) / radius;
  }
  return 8.0 * std::numbers::pi * conditions.dynamicViscosity() * flowRate / (area * area);
}

}  // namespace restenosis
