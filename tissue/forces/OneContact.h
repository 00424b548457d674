#pragma once

#include "tissue/agents/Lanes.h"

namespace restenosis {

/// Force of a contact law at one overlap [N].
template <class Law>
double forceOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<double, 1> force, stiffness;
  law.evaluate(Numbers<double, 1>(overlap), Numbers<double, 1>(reducedRadius), force, stiffness);
  return force[0];
}

/// Slope of a contact law at one overlap [N/m].
template <class Law>
double stiffnessOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<double, 1> force, stiffness;
  law.evaluate(Numbers<double, 1>(overlap), Numbers<double, 1>(reducedRadius), force, stiffness);
  return stiffness[0];
}

}  // namespace restenosis
