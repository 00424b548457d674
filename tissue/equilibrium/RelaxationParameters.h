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
  double tolerance = 0.001;               ///< how far a force left may still move its agent, over its radius
  bool activeSet = true;                  ///< move only agents that a disturbance reaches
  std::string precision = "automatic";    ///< of the forces
  double axialForceFactor = 2.0;          ///< T6's factor on axial forces: a mobility
  double stepLimit = 0.05;                ///< largest move of an agent in one step, over its radius
  std::int64_t maximumIterations = 5000;  ///< of one relaxation
  bool stopAtMaximum = false;             ///< accept what `maximumIterations` gave (T6's fixed effort)

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
