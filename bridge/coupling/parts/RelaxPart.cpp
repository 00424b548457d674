#include "bridge/coupling/parts/RelaxPart.h"

#include <array>

#include "tissue/forces/BondTurnover.h"

namespace restenosis {

std::vector<PlannedPart> RelaxPart::explain(const Scene& scene) {
  const bool grows = scene.cellCycle.has_value();
  return {{"relaxation", grows,
           grows ? "after every step in which a cell grew or divided" : "no [cellCycle]: nothing grows"}};
}

std::unique_ptr<RelaxPart> RelaxPart::make(const PartContext& context) {
  if (!context.world.scene.hasTissue()) return nullptr;
  return std::make_unique<RelaxPart>(context.world);
}

RelaxPart::RelaxPart(World& world)
    : world_(world),
      relaxation_(*world.scene.mechanics, *world.scene.relaxation, world.scene.vessel.cellRadius),
      ends_(world.wall.length) {}

Verdict RelaxPart::inputsChanged(const Instant&) const {
  if (world_.changes.changedSince(name(), Quantity::cellStates)) return Verdict::run();
  return Verdict::skip("no cell grew or divided");
}

void RelaxPart::run(const Instant& now) {
  auto measurement = world_.timer.measure("relax");
  world_.forgetLumen();
  const std::array<const Constraint*, 2> constraints{&world_.confinement, &ends_};
  const MechanicsParameters& mechanics = *world_.scene.mechanics;
  AgentStore& agents = world_.wall.agents;
  BondTable& bonds = world_.wall.bonds;
  RelaxationReport report = relaxation_.relaxAgain(agents, bonds, constraints);
  while (breakStrainedBonds(agents, bonds, mechanics.bondStrainLimit) > 0)
    report.goOnWith(relaxation_.relax(agents, bonds, constraints));
  // At rest, so that the new bonds carry nothing
  if (mechanics.bondDaughters && bondDaughters(agents, bonds, world_.scene.vessel.bondRange) > 0)
    relaxation_.forget();
  world_.relaxation.iterations += static_cast<std::uint64_t>(report.iterations);
  world_.relaxation.agentEvaluations += report.agentEvaluations;
  world_.relaxation.residual = report.residual;
  // What is recorded is copied: the relaxation makes room, or both together would be the peak of memory.
  if (now.recorded) relaxation_.forget();
  world_.changes.markRead(name(), Quantity::cellStates);
  world_.changes.touch(Quantity::agentPositions);
}

}  // namespace restenosis
