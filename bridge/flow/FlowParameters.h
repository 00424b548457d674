#pragma once

#include <cstdint>
#include <string>

#include "bridge/flow/FlowBackend.h"
#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Blood flow (model 8).
struct FlowParameters {
  static constexpr std::string_view section = "flow";
  static constexpr std::string_view summary = "Steady laminar blood flow through the lumen";

  /// Least mean velocity [m/s] (assumed). OpenFOAM adds 1e-20 to the norms of residuals, which counts in
  /// slower flow: at 1e-12 m/s the stress in a tube was found 4 % too high, at 1e-9 m/s it is that of any
  /// velocity.
  static constexpr double slowest = 1e-9;

  std::string backend = "foam";
  std::string drive = "flowRate";      ///< see keeps
  double meanVelocity = 0.133;         ///< in the undeformed lumen [m/s]
  double pressureGradient = 3547.0;    ///< -dp/dz [Pa/m]; what meanVelocity needs in a lumen of 1.8 mm
  double density = 1000.0;             ///< [kg/m^3]
  double kinematicViscosity = 2.7e-6;  ///< [m^2/s]
  double straightEnds = 0.0;           ///< of straight tube before the inlet and behind the outlet [m]
  std::string crossCheck = "none";     ///< see FlowBackendNames.h: crossChecks
  double crossCheckShare = 0.1;        ///< of the flow's time
  double crossCheckLimit = 0.1;        ///< of the stress

  void describe(ParameterVisitor& p);
  bool isCrossChecked() const;
  /// What stays fixed while the lumen narrows, as `drive` says. Throws std::invalid_argument for a word that
  /// is none of its.
  FlowConditions::Drive keeps() const;
  /// The conditions a backend solves for; the flow rate is the mean velocity times the undeformed lumen's
  /// area.
  FlowConditions conditions(double lumenDiameter) const;
  /// U D / nu in the undeformed lumen; at a fixed gradient with the mean velocity of Poiseuille's law.
  double reynoldsNumber(double lumenDiameter) const;
  /// At a fixed gradient, the mean velocity of Poiseuille's law in the undeformed lumen [m/s].
  double drivenVelocity(double lumenDiameter) const;
};

}  // namespace restenosis
