#include "bridge/coupling/parts/CyclePart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {
namespace {

// Daughters stand at the end of the store, where those around them are far away in memory. By the calendar
// and not by their number, so that nothing of it has to be remembered.
constexpr double timeBetweenOrderings = secondsPerDay;  // [s]

}  // namespace

std::vector<PlannedPart> CyclePart::explain(const Scene& scene) {
  if (!scene.cellCycle) return {{"cell cycle", false, "no [cellCycle]"}};
  std::vector<PlannedPart> parts{{"cell cycle", true, "in every step"}};
  if (const auto& activation = scene.activation) {
    parts.push_back(
        {"activation", true,
         fmt::format("by injury{}, decays in {:g} d; a fully activated cell leaves rest at {:g}/d",
                     scene.stent ? " and stretch" : "", activation->decayTime / secondsPerDay,
                     activation->entryRate * secondsPerDay)});
  }
  if (const auto& matrix = scene.extracellularMatrix) {
    parts.push_back({"matrix", true,
                     fmt::format("{:g} of a cell's volume a day, up to {:g} of the whole",
                                 matrix->rate * secondsPerDay, matrix->largestShare)});
  }
  return parts;
}

std::unique_ptr<CyclePart> CyclePart::make(const PartContext& context) {
  RunState& run = context.run;
  if (!run.scene.cellCycle) return nullptr;
  return std::make_unique<CyclePart>(run.quantities, run.biology, run.scene.scene.step, run.divisions,
                                     run.timer);
}

CyclePart::CyclePart(Quantities& quantities, Biology& biology, double step, std::uint64_t& divisions,
                     PartTimer& timer)
    : Part(quantities), biology_(biology), step_(step), divisions_(divisions), timer_(timer) {
  if (biology.rules().readWss()) read<Quantity::wallShearStress>();
}

Verdict CyclePart::needs(Quantity quantity, const Instant&) const {
  if (quantity != Quantity::wallShearStress) return Verdict::run();
  return Verdict::unless(biology_.rules().wssChangesNothingBecause(cells_->agents));
}

void CyclePart::run(const Instant& now) {
  auto measurement = timer_.measure("biology");
  const auto steps = std::max(1L, std::lround(timeBetweenOrderings / step_));
  cells_.change([&](Wall& wall) {
    if (divisions_ > 0 && now.step % steps == 0) biology_.reorder(orderInSpace(wall));
    const CycleReport report = biology_.advanceCycle(wall.agents, wall.bonds, now.time);
    divisions_ += report.divisions;
    return report.divisions > 0 || report.anyGrew;
  });
}

}  // namespace restenosis
