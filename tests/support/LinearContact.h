#pragma once

#include <cmath>
#include <string_view>

#include "tissue/agents/Lanes.h"

namespace restenosis::support {

/// A worked example of a new contact law, and all there is to write: F = k d with k = C R. Its row in the
/// table is contactLawOf<LinearContact>().
class LinearContact {
 public:
  static constexpr std::string_view name = "linear";

  explicit LinearContact(double modulus) : modulus_(modulus) {}

  template <class Real, int n>
  void evaluate(const Numbers<Real, n>& d, const Numbers<Real, n>& R, Numbers<Real, n>& force,
                Numbers<Real, n>& stiffness) const {
    force = static_cast<Real>(modulus_) * R * d;
    stiffness = (static_cast<Real>(modulus_) * R).where(Real{0} < d);
  }
  double energy(double d, double R) const { return 0.5 * modulus_ * R * d * d; }
  static double validOverlap(double /*R*/) { return HUGE_VAL; }

 private:
  double modulus_;  ///< C [Pa]
};

}  // namespace restenosis::support
