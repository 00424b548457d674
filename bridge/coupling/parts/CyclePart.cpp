#include "bridge/coupling/parts/CyclePart.h"

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
  const bool runs = scene.cellCycle.has_value();
  return {{"cell cycle", runs, runs ? "in every step" : "no [cellCycle]"}};
}

std::unique_ptr<CyclePart> CyclePart::make(const PartContext& context) {
  if (!context.world.scene.cellCycle) return nullptr;
  return std::make_unique<CyclePart>(context.world);
}

std::vector<Quantity> CyclePart::reads() const {
  std::vector<Quantity> quantities{Quantity::exposure, Quantity::nitricOxide};
  if (world_.biology.rules().readWss()) quantities.push_back(Quantity::wallShearStress);
  return quantities;
}

Verdict CyclePart::needs(Quantity quantity, const Instant&) const {
  if (quantity != Quantity::wallShearStress) return Verdict::run();
  return Verdict::unless(world_.biology.rules().wssChangesNothingBecause(world_.wall.agents));
}

void CyclePart::run(const Instant& now) {
  auto measurement = world_.timer.measure("biology");
  const auto steps = std::max(1L, std::lround(timeBetweenOrderings / world_.scene.scene.step));
  if (world_.divisions > 0 && now.step % steps == 0) world_.biology.reorder(orderInSpace(world_.wall));
  AgentStore& agents = world_.wall.agents;
  const CycleReport report = world_.biology.advanceCycle(agents, world_.wall.bonds, now.time);
  world_.divisions += report.divisions;
  if (report.divisions > 0 || report.anyGrew) world_.changes.touch(Quantity::cellStates);
}

}  // namespace restenosis
