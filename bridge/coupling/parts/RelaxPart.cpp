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
  RunState& run = context.run;
  if (!run.scene.hasTissue()) return nullptr;
  return std::make_unique<RelaxPart>(run.quantities, run.scene, run.confinement, run.extraction,
                                     run.relaxation, run.timer);
}

RelaxPart::RelaxPart(Quantities& quantities, const Scene& scene, const OuterConfinement& confinement,
                     LumenExtraction& extraction, RelaxationWork& work, PartTimer& timer)
    : Part(quantities),
      scene_(scene),
      confinement_(confinement),
      extraction_(extraction),
      work_(work),
      timer_(timer),
      relaxation_(*scene.mechanics, *scene.relaxation, scene.vessel.cellRadius),
      ends_(cells_->length) {}

Verdict RelaxPart::inputsChanged(const Instant&) const {
  return hasNewInput() ? Verdict::run() : Verdict::skip("no cell grew or divided");
}

void RelaxPart::run(const Instant& now) {
  auto measurement = timer_.measure("relax");
  extraction_.release();
  positions_.change([&](Wall& wall) { relax(wall); });
  // What is recorded is copied: the relaxation makes room, or both together would be the peak of memory.
  if (now.recorded) relaxation_.forget();
}

void RelaxPart::relax(Wall& wall) {
  const std::array<const Constraint*, 2> constraints{&confinement_, &ends_};
  const MechanicsParameters& mechanics = *scene_.mechanics;
  RelaxationReport report = relaxation_.relaxAgain(wall.agents, wall.bonds, constraints);
  while (breakStrainedBonds(wall.agents, wall.bonds, mechanics.bondStrainLimit) > 0)
    report.append(relaxation_.relax(wall.agents, wall.bonds, constraints));
  // At rest, so that the new bonds carry nothing
  if (mechanics.bondDaughters && bondDaughters(wall.agents, wall.bonds, scene_.vessel.bondRange) > 0)
    relaxation_.forget();
  work_.iterations += static_cast<std::uint64_t>(report.iterations);
  work_.agentEvaluations += report.agentEvaluations;
  work_.residual = report.residual;
}

}  // namespace restenosis
