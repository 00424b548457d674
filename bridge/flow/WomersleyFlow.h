#pragma once

#include <array>
#include <complex>

#include "bridge/flow/Waveform.h"

namespace restenosis {

/// Developed flow of a Newtonian fluid through a tube whose flow rate beats (Womersley 1955): over the mean
/// velocity,
///   u(r, t) = 2 (1 - s^2) + Re sum of a_n F_n(s) exp(i w_n t),  s = r / R,
///   F_n(s) = (1 - J0(L s) / J0(L)) / (1 - 2 J1(L) / (L J0(L))),  L = i^(3/2) R sqrt(w_n / nu).
class WomersleyFlow {
 public:
  /// Radius R [m], kinematic viscosity nu [m^2/s].
  WomersleyFlow(const Waveform& waveform, double radius, double kinematicViscosity);
  /// a_n F_n, n from 1, at r = share of R.
  std::complex<double> harmonic(std::size_t n, double share) const;
  /// u at r = share of R and the time t [s].
  double velocity(double share, double t) const;
  /// Stress on the wall at the time t [s], over that of the mean flow.
  double wallStress(double t) const;
  /// R sqrt(w_1 / nu).
  double womersleyNumber() const { return numbers_.front(); }

 private:
  Waveform waveform_;
  std::array<double, Waveform::order> numbers_{};  ///< R sqrt(w_n / nu)
};

}  // namespace restenosis
