#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace restenosis {

/// How endothelium returns (model 7): coverage c(t) = 0 before `start`, `startCoverage` at `start`, from
/// there linear to 1 at `full`, 1 afterwards. Times since the end of deployment [s].
struct EndotheliumScenario {
  std::string_view name;
  double start;
  double startCoverage;
  double full;
  std::string_view source;

  /// Share of the exposed cells that carry endothelium at `time` [s]; never falls with time.
  double coverage(double time) const;
};

/// All scenarios.
std::span<const EndotheliumScenario> endotheliumScenarios();
std::vector<std::string_view> endotheliumScenarioNames();
/// Throws std::invalid_argument, with the known names, for an unknown one.
const EndotheliumScenario& endotheliumScenario(std::string_view name);

}  // namespace restenosis
