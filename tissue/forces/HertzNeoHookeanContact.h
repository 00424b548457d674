#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "tissue/agents/Lanes.h"
#include "tissue/forces/OneContact.h"

namespace restenosis {

/// Hertz-neo-Hookean repulsion (T6): the contact disc of Hertz, radius a = sqrt(R d), carries the stress of a
/// neo-Hookean solid compressed by the strain e = 4a / (3 pi R),
///
///     F = 2 pi C a^2 (l^-2 - l),  l = 1 - e,     F > 0 repels [N],
///
/// which is Hertz with E* = 6 C for small d and stiffer beyond. The formula has a pole at e = 1 (d = 5.55 R).
///
/// **Continuation.** From e = 0.85 (d = 4.01 R) on the force goes on linearly in d with the slope it has
/// there, so that it stays finite, repulsive and monotone. Equal spheres reach d = 4 R at most, centres
/// together, and never come to the continuation; spheres with radii that differ by more than about 1.1 : 1
/// can.
class HertzNeoHookeanContact {
 public:
  static constexpr std::string_view name = "hertzNeoHookean";
  static constexpr double largestStrain = 0.85;  ///< e at which the continuation begins

  /// `modulus`: C [Pa], > 0.
  explicit HertzNeoHookeanContact(double modulus) : modulus_(modulus) {}

  /// Sets the force [N] and its slope dF/dd [N/m].
  template <class Real, int n>
  void evaluate(const Numbers<Real, n>& d, const Numbers<Real, n>& R, Numbers<Real, n>& force,
                Numbers<Real, n>& stiffness) const {
    using Values = Numbers<Real, n>;
    constexpr auto slope = static_cast<Real>(strainFactor), largest = static_cast<Real>(largestStrain),
                   validOverR = static_cast<Real>(overlapOfStrain * largestStrain * largestStrain);
    const Values e = (slope * (d / R).sqrt()).min(largest);
    const Values past = (d - validOverR * R).max(0);
    const Values inverse = Real{1} / (Real{1} - e);
    const Values scaled = static_cast<Real>(std::numbers::pi * modulus_) * R * e * inverse * inverse;
    stiffness = scaled * inverse * (Real{9} - e * (Real{15} - e * (Real{11} - Real{3} * e)));
    // 2 pi C a^2 (l^-2 - l) with a = 3 pi R e / 4 and l^-2 - l = e (3 - 3e + e^2) / l^2, free of
    // cancellation.
    force = static_cast<Real>(2 * overlapOfStrain) * scaled * R * e * e * (Real{3} - e * (Real{3} - e)) +
            stiffness * past;
  }
  /// Integral of F from 0 to d [J]
  double energy(double d, double R) const {
    const double past = d - validOverlap(R);
    if (past <= 0) return energyOfStrain(strainFactor * std::sqrt(d / R), R);
    const double force = forceOf(*this, validOverlap(R), R),
                 stiffness = stiffnessOf(*this, validOverlap(R), R);
    return energyOfStrain(largestStrain, R) + past * (force + 0.5 * past * stiffness);
  }
  /// Overlap at which the continuation begins [m].
  static double validOverlap(double R) { return overlapOfStrain * R * largestStrain * largestStrain; }

 private:
  static constexpr double pi2 = std::numbers::pi * std::numbers::pi;
  static constexpr double strainFactor = 4 / (3 * std::numbers::pi);  ///< e = strainFactor sqrt(d / R)
  static constexpr double overlapOfStrain = 9 * pi2 / 16;             ///< d = overlapOfStrain R e^2

  double energyOfStrain(double e, double R) const {
    constexpr double factor = 81 * pi2 * pi2 * std::numbers::pi / 64;
    return factor * modulus_ * R * R * R * energyIntegral(e);
  }
  /// Integral of e^4 (3 - 3e + e^2) / (1 - e)^2 from 0 to e: in closed form, or by its series where that
  /// cancels.
  static double energyIntegral(double e) {
    if (e < 0.2) {
      double sum = 0;
      for (int k = 20; k >= 0; --k) sum = sum * e + (k == 0 ? 3.0 : k + 2.0) / (k + 5);
      return sum * std::pow(e, 5);
    }
    const double l = 1 - e;
    return 1 / l + 3 * std::log(l) + l * (-3 + l * (1 + l * (-1 + l * (0.75 - 0.2 * l)))) + 1.45;
  }

  double modulus_;  ///< C [Pa]
};

}  // namespace restenosis
