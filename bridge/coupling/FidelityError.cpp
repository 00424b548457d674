#include "bridge/coupling/FidelityError.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/flow/FlowBackendNames.h"

namespace restenosis {
namespace {

struct Measured {
  std::string_view fidelity;
  bool bulk;          ///< whether the bulk grows: [activation]
  double cellRadius;  ///< [m]
  FidelityError error;
};

/// bench/data/fidelities.csv, day 28: the area in seed 1 from that at `reference`, half the range of three
/// seeds at `draft`.
constexpr std::array measured = {
    Measured{"draft", false, 15e-6, {-0.042, 0.053}},  Measured{"standard", false, 15e-6, {-0.042, 0.053}},
    Measured{"reference", false, 15e-6, {0, 0.053}},   Measured{"draft", true, 15e-6, {0.118, 0.186}},
    Measured{"standard", true, 15e-6, {0.088, 0.186}}, Measured{"reference", true, 15e-6, {0, 0.186}},
};
/// How far a cell's radius may be from that of a measurement, as a share of it (assumed).
constexpr double alike = 0.1;

bool followsFidelity(const Scene& scene) {
  const auto usual = CouplingParameters::forFidelity(scene.scene.fidelity);
  return !scene.foam && scene.coupling.lumenTolerance == usual.lumenTolerance &&
         scene.coupling.lumenInterval == usual.lumenInterval &&
         scene.coupling.scheduleMode() == ScheduleMode::onChange;
}

}  // namespace

std::optional<FidelityError> fidelityError(const Scene& scene) {
  if (!scene.hasTissue() || !scene.stent || !noFlowBecause(scene).empty() || !followsFidelity(scene) ||
      scene.flow->backend != flowBackendNames::foam)
    return std::nullopt;
  const auto found = std::ranges::find_if(measured, [&](const Measured& m) {
    return m.fidelity == scene.scene.fidelity && m.bulk == scene.activation.has_value() &&
           std::abs(scene.vessel.cellRadius / m.cellRadius - 1) < alike;
  });
  if (found == measured.end()) return std::nullopt;
  return found->error;
}

std::string fidelityErrorText(const Scene& scene) {
  const auto error = fidelityError(scene);
  if (!error) return "";
  const std::string_view fidelity = scene.scene.fidelity;
  const std::string off =
      fidelity == "reference" ? "" : fmt::format("{:+.0f} % of that at reference, ", 100 * error->area);
  return fmt::format(
      "error: neointimal area at {}: {}seeds differ by +-{:.0f} % (measured in one ring; in this scene: "
      "tradeoff)\n",
      fidelity, off, 100 * error->seeds);
}

}  // namespace restenosis
