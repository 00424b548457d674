#pragma once

#include "tissue/equilibrium/RelaxationParameters.h"
#include "tissue/forces/MechanicsParameters.h"

namespace restenosis {

/// Forces, and the way to their equilibrium.
struct Mechanics {
  MechanicsParameters forces;
  RelaxationParameters relaxation;
};

}  // namespace restenosis
