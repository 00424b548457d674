#include "bridge/flow/foam/WomersleyProfile.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "bridge/flow/WomersleyFlow.h"
#include "bridge/flow/foam/PowersOfW.h"

namespace restenosis {

WomersleyProfile womersleyProfile(const FlowConditions& conditions, double radius) {
  const Waveform& waveform = conditions.beating->waveform;
  const WomersleyFlow flow(waveform, radius, conditions.kinematicViscosity);
  const double area = std::numbers::pi * radius * radius;
  WomersleyProfile profile;
  double square = 0;
  for (std::size_t n = 1; n <= Waveform::order; ++n) {
    const PowersOfW real([&](double share) { return flow.harmonic(n, share).real() / area; });
    const PowersOfW imaginary([&](double share) { return flow.harmonic(n, share).imag() / area; });
    square += (std::pow(real.error(), 2) + std::pow(imaginary.error(), 2)) / 2;
    const double frequency = waveform.angularFrequency(n);
    const std::complex<double> a = waveform.harmonics[n - 1];
    profile.velocities[n - 1] = fmt::format("cos({0:.12g}*t)*{1}-sin({0:.12g}*t)*{2}", frequency,
                                            real.expression(), imaginary.expression());
    profile.flowRate += fmt::format("{}({:.9g})*cos({:.12g}*t)-({:.9g})*sin({:.12g}*t)", n > 1 ? "+" : "",
                                    a.real(), frequency, a.imag(), frequency);
  }
  profile.error = std::sqrt(square) * area;
  return profile;
}

}  // namespace restenosis
