#include "tissue/biology/Biology.h"

#include <limits>

namespace restenosis {

namespace {

ContactInhibition makeInhibition(const BiologySettings& settings) {
  const auto& section = settings.contactInhibition;
  return {section.value_or(ContactInhibitionParameters{}),
          section ? makeContactInhibitionLaw(*section) : nullptr, settings.vesselLength};
}

}  // namespace

Biology::Biology(const BiologySettings& settings, std::span<const MakeArrestRule> rules)
    : rules_(settings, rules), inhibition_(makeInhibition(settings)) {
  if (settings.endothelium) {
    endothelium_.emplace(*settings.endothelium, settings.seed, settings.denuded);
    nitricOxide_.emplace(*settings.endothelium);
  }
  if (settings.cellCycle) {
    cycle_.emplace(*settings.cellCycle, settings.seed, settings.step);
    division_.emplace(settings.seed, settings.cellCycle->daughterDisplacement);
  }
}

CoverageReport Biology::updateEndothelium(AgentStore& agents, double time) const {
  return endothelium_ ? endothelium_->apply(agents, time) : CoverageReport{};
}

void Biology::updateNitricOxide(AgentStore& agents) const {
  if (nitricOxide_) nitricOxide_->apply(agents);
}

CycleReport Biology::advanceCycle(AgentStore& agents, BondTable& bonds, double time) const {
  CycleReport report;
  if (!cycle_) return report;
  const auto mothers = cycle_->advance(agents, rules_, report, time);
  division_->divide(agents, bonds, mothers);
  report.divisions = static_cast<Index>(mothers.size());
  return report;
}

double Biology::endotheliumOnset() const {
  return endothelium_ ? endothelium_->onset() : std::numeric_limits<double>::infinity();
}

double Biology::arrestingWss() const {
  return nitricOxide_ ? nitricOxide_->wssForNitricOxide(nitricOxide_->threshold())
                      : std::numeric_limits<double>::infinity();
}

}  // namespace restenosis
