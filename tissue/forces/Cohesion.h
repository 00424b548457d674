#pragma once

#include <algorithm>

#include "tissue/agents/Lanes.h"

namespace restenosis {

/// Weak attraction that keeps daughters at the tissue (assumed): between separated agents of which at least
/// one is a daughter, k (R1 + R2) g [N] for a gap g, rising up to half the range G = (range - 1)(R1 + R2) and
/// falling back to zero at G. Starts and ends at zero, so it disturbs no contact.
struct Cohesion {
  double modulus;  ///< k [Pa], >= 0
  double range;    ///< distance at which it ends, over R1 + R2, >= 1

  /// Pull [N], >= 0. `sum`: R1 + R2 [m].
  double pull(double gap, double sum) const {
    return modulus * sum * std::max(0.0, std::min(gap, (range - 1) * sum - gap));
  }
  /// Largest slope of the pull [N/m].
  double stiffness(double sum) const { return modulus * sum; }
  /// Both for several pairs at once, slopes of acting pairs only.
  template <class Real, int n>
  void evaluate(const Numbers<Real, n>& gap, const Numbers<Real, n>& sum, Numbers<Real, n>& pulls,
                Numbers<Real, n>& slopes) const {
    const Numbers<Real, n> reach = gap.min(static_cast<Real>(range - 1) * sum - gap).max(0);
    slopes = (static_cast<Real>(modulus) * sum).where(Real{0} < reach);
    pulls = slopes * reach;
  }
  /// Energy, zero out of range [J].
  double energy(double gap, double sum) const {
    const double end = (range - 1) * sum;
    if (gap >= end) return 0;
    const double whole = modulus * sum * end * end / 4;
    if (gap <= 0) return -whole;
    const double rise = std::min(gap, end / 2), fall = std::max(0.0, gap - end / 2);
    return -whole + modulus * sum * (0.5 * rise * rise + fall * (end / 2 - 0.5 * fall));
  }
};

}  // namespace restenosis
