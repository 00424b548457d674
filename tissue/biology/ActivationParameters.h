#pragma once

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Activation of cells by injury and stretch (model 5).
struct ActivationParameters {
  static constexpr std::string_view section = "activation";
  static constexpr std::string_view summary = "Injury and stretch tell cells to grow, for a while";

  double entryRate = 0.25 / 86400.0;  ///< rate at which a fully activated cell at rest enters G1 [1/s]
  double decayTime = 10 * 86400.0;    ///< of the activation [s]
  double stretchOnset = 0.05;         ///< strain around the vessel from which on it activates
  double stretchFull = 0.25;          ///< strain at which it activates fully

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
