#pragma once

#include "tissue/agents/Lanes.h"

namespace restenosis {

/// Pull of a bond (form and constant: ISR3D): F = k strain (R1 + R2)^2 [N], strain = (distance - rest) /
/// rest, in tension only. A bond that makes the angle t with the vessel's axis has the stiffness k (1 +
/// (axialFactor - 1) cos^2 t): `axialFactor` times that of a bond across the axis when it lies along it. The
/// force acts along the line of centres whatever the factor; with a factor other than 1 it has no potential.
struct BondAttraction {
  double modulus;      ///< k [Pa], >= 0
  double axialFactor;  ///< > 0

  /// Pull [N], >= 0. `axialCosine2`: cos^2 t. `sum`: R1 + R2 [m].
  double pull(double distance, double rest, double sum, double axialCosine2) const {
    return distance > rest ? stiffness(rest, sum, axialCosine2) * (distance - rest) : 0.0;
  }
  /// Slope of the pull while the bond is stretched [N/m].
  double stiffness(double rest, double sum, double axialCosine2) const {
    return modulus * (1 + (axialFactor - 1) * axialCosine2) * sum * sum / rest;
  }
  /// Both for several bonds at once, slack ones having neither pull nor slope. A bond of infinite rest length
  /// is no bond.
  template <class Real, int n>
  void evaluate(const Numbers<Real, n>& distance, const Numbers<Real, n>& rest, const Numbers<Real, n>& sum,
                const Numbers<Real, n>& axialCosine2, Numbers<Real, n>& pulls,
                Numbers<Real, n>& slopes) const {
    slopes = (static_cast<Real>(modulus) * (Real{1} + static_cast<Real>(axialFactor - 1) * axialCosine2) *
              sum * sum / rest)
                 .where(rest < distance);
    pulls = slopes * (distance - rest).max(0);
  }
  /// Energy of a bond across the axis [J].
  double energy(double distance, double rest, double sum) const {
    const double stretch = distance > rest ? distance - rest : 0.0;
    return 0.5 * stiffness(rest, sum, 0) * stretch * stretch;
  }
};

}  // namespace restenosis
