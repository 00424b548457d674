#pragma once

#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Contact and attraction (model 3).
struct MechanicsParameters {
  static constexpr std::string_view section = "mechanics";
  static constexpr std::string_view summary = "Forces between agents";

  std::string contactLaw = "hertzNeoHookean";
  double contactModulus = 0.2e6;    ///< C of the neo-Hookean law [Pa]; E* = 6 C
  double bondModulus = 2.18e6;      ///< k of the bonds [Pa]
  double bondAxialFactor = 1.0;     ///< stiffness of a bond along the axis over that of one around
  double bondStrainLimit = 0;       ///< strain past which a bond outside the IEL breaks; 0: no limit
  bool bondDaughters = false;       ///< whether daughters are bonded once they have come to rest
  double cohesionModulus = 0.02e6;  ///< of the weak attraction of daughters [Pa]
  double cohesionRange = 1.2;       ///< it ends at this times R1 + R2

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
