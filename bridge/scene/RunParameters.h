#pragma once

#include <cstdint>
#include <string>

#include "tissue/parameters/ParameterVisitor.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

/// What is run, for how long and how finely.
struct SceneParameters {
  static constexpr std::string_view section = "scene";
  static constexpr std::string_view summary = "What is run, for how long and how finely";

  std::string title;
  double duration = 0;  ///< [s]
  double step = 3600;   ///< biological step [s]
  std::int64_t seed = 1;
  std::string fidelity = "standard";

  void describe(ParameterVisitor& p);
};

/// When which part of the loop runs (model 9).
struct CouplingParameters {
  static constexpr std::string_view section = "coupling";
  static constexpr std::string_view summary = "When the lumen surface is taken and the flow solved";

  std::string schedule = "onChange";
  double lumenTolerance = 5e-6;  ///< [m]
  double undecidedMargin = 2.5;  ///< undecided is a cell below this times the arresting stress
  double undecidedShare = 0.03;  ///< of these cells, where the lumen may have moved further
  std::string stressUpdate = "firstOrder";
  double surfaceSmoothing = 30e-6;   ///< cell scale at which the lumen surface is smoothed [m]
  double surfaceResolution = 15e-6;  ///< spacing of the distance field [m]
  std::string remesh = "always";

  void describe(ParameterVisitor& p);
};

/// What is written, and how often.
struct OutputParameters {
  static constexpr std::string_view section = "output";
  static constexpr std::string_view summary = "What is written, and how often";

  double interval = secondsPerDay;                ///< between recorded states [s]
  double checkpointInterval = 7 * secondsPerDay;  ///< of simulated time [s]
  std::string keepFlowCases = "last";
  bool pictures = true;

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
