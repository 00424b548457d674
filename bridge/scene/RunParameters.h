#pragma once

#include <cstdint>
#include <string>
#include <string_view>

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

/// When parts of the loop run: each only when its answer may have changed, or all in every step (T6).
enum class ScheduleMode : std::uint8_t { onChange, everyStep };

/// When which part of the loop runs (model 9).
struct CouplingParameters {
  static constexpr std::string_view section = "coupling";
  static constexpr std::string_view summary = "When the lumen surface is taken and the flow solved";

  std::string schedule = "onChange";        ///< see scheduleMode
  double lumenTolerance = 10e-6;            ///< [m]
  double lumenInterval = 0;                 ///< [s]
  double undecidedMargin = 2.5;             ///< undecided is a cell below this times the arresting stress
  double undecidedShare = 0.03;             ///< of these cells, where the lumen may have moved further
  std::string stressUpdate = "firstOrder";  ///< see stressFollowsLumen
  double surfaceSmoothing = 30e-6;          ///< cell scale at which the lumen surface is smoothed [m]
  double surfaceResolution = 15e-6;         ///< spacing of the distance field [m]
  std::string remesh = "always";            ///< see movesMesh

  void describe(ParameterVisitor& p);
  /// What the words say. Throw std::invalid_argument for one that is none of theirs.
  ScheduleMode scheduleMode() const;
  /// Whether the stress on cells follows the lumen between two solves.
  bool stressFollowsLumen() const;
  /// Whether the last mesh is moved while that is good enough, and not every lumen meshed afresh.
  bool movesMesh() const;

  /// The settings of a fidelity level: draft, standard or reference. Throws std::invalid_argument for others.
  static CouplingParameters forFidelity(std::string_view fidelity);
  /// Its keys that a fidelity decides, as "section.key": how accurately, and not what, is run.
  static bool followsFidelity(std::string_view name);
};

/// What is written, and how often.
struct OutputParameters {
  static constexpr std::string_view section = "output";
  static constexpr std::string_view summary = "What is written, and how often";

  double interval = secondsPerDay;                ///< between recorded states [s]
  double checkpointInterval = 7 * secondsPerDay;  ///< of simulated time [s]
  std::string keepFlowCases = "last";             ///< see keepsAllFlowCases
  bool pictures = true;

  void describe(ParameterVisitor& p);
  /// Whether the case of every solve is kept, and not the last one's only. Throws as above.
  bool keepsAllFlowCases() const;
};

}  // namespace restenosis
