#pragma once

#include <array>
#include <string>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// The harmonics of a beating flow as OpenFOAM's expressions.
struct WomersleyProfile {
  /// Of each harmonic, the velocity over the mean flow rate [1/m^2], a function of w = 1 - r^2 / R^2 and of t
  /// [s]: Womersley's profile by powers of w.
  std::array<std::string, Waveform::order> velocities;
  std::string flowRate;  ///< of all harmonics over the mean one, a function of t
  /// By how much the powers miss the profile: root mean square, over the mean velocity.
  double error = 0.0;
};

/// For an inlet of the radius [m]; blood that thins has the viscosity at the wall.
WomersleyProfile womersleyProfile(const FlowConditions& conditions, double radius);

}  // namespace restenosis
