#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace restenosis {

/// How endothelium returns (model 7): its coverage c(t) is a line through points, 0 before the first and that
/// of the last behind it. Two points at one time are a jump.
struct EndotheliumScenario {
  struct Point {
    double time;      ///< since the end of deployment [s]
    double coverage;  ///< not below that of the point before
  };
  std::string_view name;
  std::array<Point, 3> points;
  std::string_view source;

  /// Share of the exposed cells that carry endothelium at `time` [s]; never falls with time.
  double coverage(double time) const;
  /// Time before which there is none [s]; infinity for never any.
  double onset() const { return points.front().time; }
  /// Time from which on there is no more of it [s]; infinity for never any.
  double completion() const { return points.back().time; }
};

/// All scenarios.
std::span<const EndotheliumScenario> endotheliumScenarios();
std::vector<std::string_view> endotheliumScenarioNames();
/// Throws std::invalid_argument, with the known names, for an unknown one.
const EndotheliumScenario& endotheliumScenario(std::string_view name);

}  // namespace restenosis
