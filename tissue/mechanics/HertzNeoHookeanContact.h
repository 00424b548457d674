#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

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
/// together, and never come to the continuation; spheres whose radii differ by more than about 1.1 : 1 can.
class HertzNeoHookeanContact {
 public:
  static constexpr std::string_view name = "hertzNeoHookean";
  static constexpr double largestStrain = 0.85;  ///< e at which the continuation begins

  /// `modulus`: C [Pa], > 0.
  explicit HertzNeoHookeanContact(double modulus) : modulus_(modulus) {}

  /// [N]
  double force(double d, double R) const {
    const double e = strain(d, R);
    if (e <= largestStrain) return forceOfStrain(e, R);
    return forceOfStrain(largestStrain, R) + slopeOfStrain(largestStrain, R) * (d - validOverlap(R));
  }
  /// dF/dd [N/m]
  double stiffness(double d, double R) const {
    return slopeOfStrain(std::fmin(strain(d, R), largestStrain), R);
  }
  /// Integral of F from 0 to d [J]
  double energy(double d, double R) const {
    const double e = strain(d, R);
    if (e <= largestStrain) return energyOfStrain(e, R);
    const double past = d - validOverlap(R);
    return energyOfStrain(largestStrain, R) +
           past * (forceOfStrain(largestStrain, R) + 0.5 * past * slopeOfStrain(largestStrain, R));
  }
  /// Overlap at which the continuation begins [m].
  static double validOverlap(double R) {
    return 9 * std::numbers::pi * std::numbers::pi / 16 * R * largestStrain * largestStrain;
  }

 private:
  static double strain(double d, double R) { return 4 / (3 * std::numbers::pi) * std::sqrt(d / R); }

  /// 2 pi C a^2 (l^-2 - l) with a = 3 pi R e / 4 and l^-2 - l = e (3 - 3e + e^2) / l^2, free of cancellation.
  double forceOfStrain(double e, double R) const {
    constexpr double factor = 9 * std::numbers::pi * std::numbers::pi * std::numbers::pi / 8;
    const double l = 1 - e;
    return factor * modulus_ * R * R * e * e * e * (3 - e * (3 - e)) / (l * l);
  }
  /// dF/dd = (dF/de) / (dd/de) with d = 9 pi^2 R e^2 / 16.
  double slopeOfStrain(double e, double R) const {
    const double l = 1 - e;
    return std::numbers::pi * modulus_ * R * e * (9 - e * (15 - e * (11 - 3 * e))) / (l * l * l);
  }
  double energyOfStrain(double e, double R) const {
    constexpr double pi2 = std::numbers::pi * std::numbers::pi;
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
