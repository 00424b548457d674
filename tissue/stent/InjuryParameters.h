#pragma once

#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// What deployment does to the laminae and which cells become synthetic (model 4).
struct InjuryParameters {
  static constexpr std::string_view section = "injury";
  static constexpr std::string_view summary =
      "Which lamina agents break or become permeable, which cells become synthetic";

  bool ielBreaks = false;
  double strainLimitAround = 0.095;
  double strainLimitAlong = 0.05;
  double stressLimit = 0.0;  ///< on the magnitude of AgentStore::stress [Pa]; 0: no limit
  double fenestrationProbability = 0.06;
  double stretchedStrain = 0.045;  ///< above this the IEL is "the stretched region"
  double endMargin = 0.2e-3;       ///< [m] the IEL nearer a fixed end is never injured
  double syntheticReach = 1.5;     ///< SMC within this times R1 + R2 of an injured IEL agent become synthetic
  std::string synthetic = "nearInjury";  ///< see everyCellSynthetic
  std::string denudation = "full";       ///< see denuded
  bool removeIel = false;                ///< remove the whole IEL before growth

  void describe(ParameterVisitor& p);
  /// The values of `synthetic` and `denudation`: whether all cells may cycle and not only those near an
  /// injury, and whether deployment strips the endothelium. Throw std::invalid_argument for an unknown word.
  bool everyCellSynthetic() const;
  bool denuded() const;
  /// Whether the IEL of a packed wall stays whole, with or without a stent.
  bool sparesIel(bool stented) const;
};

}  // namespace restenosis
