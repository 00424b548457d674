#pragma once

#include <cstdint>
#include <string>

#include "ParameterVisitor.h"

namespace restenosis {

/// Contact, attraction and relaxation (model 3).
struct MechanicsParameters {
  static constexpr std::string_view section = "mechanics";
  static constexpr std::string_view summary = "Forces between agents and the relaxation to equilibrium";

  std::string contactLaw = "hertzNeoHookean";
  double contactModulus = 0.2e6;    ///< C of the neo-Hookean law [Pa]; E* = 6 C
  double bondModulus = 2.18e6;      ///< k of the bonds [Pa]
  double bondAxialFactor = 1.0;     ///< stiffness of a bond along the axis over that of one around
  double bondStrainLimit = 0;       ///< strain past which a bond outside the IEL breaks; 0: no limit
  bool bondDaughters = false;       ///< whether daughters are bonded once they have come to rest
  double cohesionModulus = 0.02e6;  ///< of the weak attraction of daughters [Pa]
  double cohesionRange = 1.2;       ///< it ends at this times R1 + R2
  double axialForceFactor = 2.0;    ///< T6's factor on axial forces: a mobility
  std::string minimiser = "fire";
  std::string precision = "automatic";    ///< of the forces on the way to equilibrium
  double firmStiffness = 20;              ///< of contacts that hold a daughter firmly, over C r0
  double tolerance = 0.04;                ///< largest residual over F_char = C r0^2
  bool sleeping = true;                   ///< only agents that a disturbance reaches are moved
  std::int64_t yieldIterations = 20;      ///< in which daughters around a disturbance move, restless or not
  double stepLimit = 0.05;                ///< largest move of an agent in one step, over its radius
  std::int64_t maximumIterations = 5000;  ///< of one relaxation
  bool stopAtMaximum = false;             ///< accept what `maximumIterations` gave (T6's fixed effort)

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
