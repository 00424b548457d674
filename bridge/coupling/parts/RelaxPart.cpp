#include "RelaxPart.h"

#include <array>

namespace restenosis {

RelaxPart::RelaxPart(World& world)
    : world_(world),
      relaxation_(*world.scene.mechanics, world.scene.vessel.cellRadius),
      ends_(world.wall.length) {}

Verdict RelaxPart::inputsChanged(const Instant&) const {
  if (world_.changes.changedSince(name(), Quantity::cellStates)) return Verdict::run();
  return Verdict::skip("no cell grew or divided");
}

void RelaxPart::run(const Instant& now) {
  auto measurement = world_.timer.measure("relax");
  world_.forgetLumen();
  const std::array<const Constraint*, 2> constraints{&world_.confinement, &ends_};
  const RelaxationReport report = relaxation_.relaxAgain(world_.wall.agents, world_.wall.bonds, constraints);
  world_.relaxation.iterations += static_cast<std::uint64_t>(report.iterations);
  world_.relaxation.agentEvaluations += report.agentEvaluations;
  // What is recorded is copied: the relaxation makes room, or both together would be the peak of memory.
  if (now.recorded) relaxation_.forget();
  world_.changes.markRead(name(), Quantity::cellStates);
  world_.changes.touch(Quantity::agentPositions);
}

}  // namespace restenosis
