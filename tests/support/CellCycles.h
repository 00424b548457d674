#pragma once

#include "tissue/biology/CellCycleParameters.h"

namespace restenosis::support {

/// A cycle whose phases have the same length in every cell [s].
inline CellCycleParameters phases(double g1, double sg2m) {
  CellCycleParameters parameters;
  parameters.g1Mean = g1;
  parameters.g1Spread = 0;
  parameters.sg2mDuration = sg2m;
  return parameters;
}

}  // namespace restenosis::support
