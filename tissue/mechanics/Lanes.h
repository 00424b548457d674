#pragma once

#include <Eigen/Core>

namespace restenosis {

/// Several numbers on which arithmetic, sqrt(), min() and max() work element by element.
template <int n>
using Numbers = Eigen::Array<double, n, 1>;

/// As many pairs as the processor computes at once. Pairs are always computed in such groups, the last one
/// filled up, so that a pair's force has the same bits wherever in a group it stands.
inline constexpr int laneCount = 4;
using Lanes = Numbers<laneCount>;

/// Force of a contact law at one overlap [N].
template <class Law>
double forceOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<1> force, stiffness;
  law.evaluate(Numbers<1>(overlap), Numbers<1>(reducedRadius), force, stiffness);
  return force[0];
}

/// Slope of a contact law at one overlap [N/m].
template <class Law>
double stiffnessOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<1> force, stiffness;
  law.evaluate(Numbers<1>(overlap), Numbers<1>(reducedRadius), force, stiffness);
  return stiffness[0];
}

}  // namespace restenosis
