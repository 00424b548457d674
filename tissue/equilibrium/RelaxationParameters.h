#pragma once

#include <cstdint>
#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// How agents are brought to mechanical equilibrium (model 3).
struct RelaxationParameters {
  static constexpr std::string_view section = "relaxation";
  static constexpr std::string_view summary = "How agents are brought to equilibrium; absent: the defaults";

  std::string minimiser = "fire";
  std::string precision = "automatic";    ///< of the forces on the way to equilibrium
  double firmStiffness = 20;              ///< of contacts that hold a daughter firmly, over C r0
  double tolerance = 0.04;                ///< largest residual over F_char = C r0^2
  bool sleeping = true;                   ///< only agents that a disturbance reaches are moved
  std::int64_t yieldIterations = 20;      ///< in which daughters around a disturbance move, restless or not
  double stepLimit = 0.05;                ///< largest move of an agent in one step, over its radius
  std::int64_t maximumIterations = 5000;  ///< of one relaxation
  bool stopAtMaximum = false;             ///< accept what `maximumIterations` gave (T6's fixed effort)
  double axialForceFactor = 2.0;          ///< T6's factor on axial forces: a mobility

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
