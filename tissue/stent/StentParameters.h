#pragma once

#include <cstdint>
#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// The stent and how it is pressed in (model 2 and 4).
struct StentParameters {
  static constexpr std::string_view section = "stent";
  static constexpr std::string_view summary =
      "Struts pressed into the wall in equal steps, the wall relaxing after each";

  std::string design = "ring";
  std::string file;                   ///< STL of the struts or CSV of obstacle agents instead of a design
  std::string fileUnit = "mm";        ///< of an STL
  double length = 3.5e-3;             ///< of designs longer than one ring [m]
  double strutWidth = 0.09e-3;        ///< along the surface [m]
  double strutThickness = 0.09e-3;    ///< along the radius [m]
  std::string strutShape = "square";  ///< cross-section
  std::int64_t ringCount = 7;         ///< rings of "rings", "ringsWithLinks", "biodivysio"
  std::int64_t linkCount = 4;         ///< links between neighbouring rings
  std::int64_t ringWaves = 6;         ///< waves around of a sinusoidal ring
  double ringAmplitude = 0.15e-3;     ///< axial amplitude of a sinusoidal ring [m]
  double helixTurns = 5;
  double deploymentDepth = 110e-6;  ///< of the struts' outer face beyond the undeformed lumen [m]
  std::int64_t deploymentSteps = 100;
  std::string outerLamina = "free";  ///< see fixesOuterLamina

  void describe(ParameterVisitor& p);
  /// Whether the EEL is fixed during deployment. Throws std::invalid_argument for an unknown `outerLamina`.
  bool fixesOuterLamina() const;
};

}  // namespace restenosis
