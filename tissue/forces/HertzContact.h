#pragma once

#include <cmath>
#include <string_view>

#include "tissue/agents/Lanes.h"
#include "tissue/forces/OneContact.h"

namespace restenosis {

/// Hertz repulsion of two elastic spheres (T6): F = 4/3 E* sqrt(R) d^(3/2) [N], F > 0 repels, with overlap
/// d = R1 + R2 - |r1 - r2|, 1/R = 1/R1 + 1/R2 and E* = 6 C. Exact for small overlaps of linear elastic
/// spheres.
///
/// A contact law has these functions of the overlap d >= 0 [m] and the reduced radius R > 0 [m]; an object of
/// it holds the material. `evaluate` works on several pairs at once, in single or double precision.
class HertzContact {
 public:
  static constexpr std::string_view name = "hertz";

  /// `modulus`: C [Pa], > 0.
  explicit HertzContact(double modulus) : effectiveModulus_(6 * modulus) {}

  /// Sets the force [N] and its slope dF/dd [N/m].
  template <class Real, int n>
  void evaluate(const Numbers<Real, n>& d, const Numbers<Real, n>& R, Numbers<Real, n>& force,
                Numbers<Real, n>& stiffness) const {
    const Numbers<Real, n> a = (R * d).sqrt();
    force = static_cast<Real>(4.0 / 3.0 * effectiveModulus_) * a * d;
    stiffness = static_cast<Real>(2 * effectiveModulus_) * a;
  }
  /// Integral of F from 0 to d [J]
  double energy(double d, double R) const {
    return 8.0 / 15.0 * effectiveModulus_ * std::sqrt(R * d) * d * d;
  }
  /// Overlap up to which the law is the published one [m]; here all.
  static double validOverlap(double /*R*/) { return HUGE_VAL; }

 private:
  double effectiveModulus_;  ///< E* [Pa]
};

}  // namespace restenosis
