#include "bridge/flow/WomersleyFlow.h"

#include <cmath>
#include <numbers>

namespace restenosis {
namespace {

using Complex = std::complex<double>;
using namespace std::complex_literals;

/// Below this size of L, F is that of steady flow within 1e-8.
constexpr double quasiSteady = 1e-3;
/// Beyond this size of its argument, Hankel's expansion is as good as the power series.
constexpr double farOut = 25;

/// J_order(z) exp(iz), which stays finite in the upper half plane.
Complex scaledBessel(int order, Complex z) {
  if (std::abs(z) < farOut) {
    const Complex square = -0.25 * z * z;
    Complex term = order == 0 ? Complex(1) : 0.5 * z, sum = term;
    for (int k = 1; std::abs(term) > 1e-18 * std::abs(sum); ++k)
      sum += term *= square / static_cast<double>(k * (k + order));
    return sum * std::exp(1i * z);
  }
  // DLMF 10.17.5 and 10.17.6; the part that falls exp(-2 Im z) below the other is left out
  Complex term = 1, sum = 1;
  for (int k = 1; k < 2 * farOut; ++k) {
    const double odd = 2 * k - 1;
    const Complex next = term * (4.0 * order * order - odd * odd) / (8.0 * k * z) * -1i;
    if (std::abs(next) > std::abs(term)) break;
    sum += term = next;
  }
  return std::exp(1i * (0.5 * order + 0.25) * std::numbers::pi) * sum / std::sqrt(2 * std::numbers::pi * z);
}

Complex argument(double number) { return std::polar(number, 0.75 * std::numbers::pi); }

/// 1 - 2 J1(L) / (L J0(L)).
Complex denominator(Complex l) { return 1.0 - 2.0 * scaledBessel(1, l) / (l * scaledBessel(0, l)); }

}  // namespace

WomersleyFlow::WomersleyFlow(const Waveform& waveform, double radius, double kinematicViscosity)
    : waveform_(waveform) {
  for (std::size_t n = 1; n <= Waveform::order; ++n)
    numbers_[n - 1] = radius * std::sqrt(waveform.angularFrequency(n) / kinematicViscosity);
}

std::complex<double> WomersleyFlow::harmonic(std::size_t n, double share) const {
  const double number = numbers_[n - 1];
  if (number < quasiSteady) return waveform_.harmonics[n - 1] * 2.0 * (1 - share * share);
  const Complex l = argument(number);
  const Complex ratio = scaledBessel(0, l * share) / scaledBessel(0, l) * std::exp(1i * l * (1 - share));
  return waveform_.harmonics[n - 1] * (1.0 - ratio) / denominator(l);
}

double WomersleyFlow::velocity(double share, double t) const {
  double velocity = 2 * (1 - share * share);
  for (std::size_t n = 1; n <= Waveform::order; ++n)
    velocity += (harmonic(n, share) * std::polar(1.0, waveform_.angularFrequency(n) * t)).real();
  return velocity;
}

double WomersleyFlow::wallStress(double t) const {
  double stress = 1;
  for (std::size_t n = 1; n <= Waveform::order; ++n) {
    Complex share = 1;
    if (const double number = numbers_[n - 1]; number >= quasiSteady) {
      const Complex l = argument(number);
      share = -l * scaledBessel(1, l) / scaledBessel(0, l) / denominator(l) / 4.0;
    }
    stress +=
        (waveform_.harmonics[n - 1] * share * std::polar(1.0, waveform_.angularFrequency(n) * t)).real();
  }
  return stress;
}

}  // namespace restenosis
