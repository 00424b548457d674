#pragma once

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// The cell cycle (model 5).
struct CellCycleParameters {
  static constexpr std::string_view section = "cellCycle";
  static constexpr std::string_view summary = "Synthetic cells grow and divide";

  double g1Mean = 16 * 3600.0;        ///< [s]
  double g1Spread = 2 * 3600.0;       ///< standard deviation [s]
  double sg2mDuration = 16 * 3600.0;  ///< [s]
  double recruitment = 0;             ///< time over which the first cells leave rest one after another [s]
  double daughterDisplacement = 0.4;  ///< of mother and daughter from the mother's centre, over her radius

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
