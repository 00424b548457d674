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
    : rules_(settings, rules),
      inhibition_(makeInhibition(settings)),
      step_(settings.step),
      endotheliumMatures_(settings.endothelium && settings.endothelium->maturationTime > 0) {
  if (settings.endothelium) {
    endothelium_.emplace(*settings.endothelium, settings.seed, settings.denuded);
    nitricOxide_.emplace(*settings.endothelium);
  }
  if (settings.activation) activation_.emplace(*settings.activation, settings.seed, settings.step);
  if (settings.extracellularMatrix) matrix_.emplace(*settings.extracellularMatrix);
  if (settings.cellCycle) {
    cycle_.emplace(*settings.cellCycle, settings.seed, settings.step, activation_);
    division_.emplace(settings.seed, settings.cellCycle->daughterDisplacement);
  }
}

void Biology::model(AgentStore& agents) const {
  if (activation_) agents.activation.model(agents.size());
  if (matrix_) agents.matrix.model(agents.size());
  if (endotheliumMatures_) agents.maturity.model(agents.size());
}

void Biology::stretch(AgentStore& agents, std::span<const double> strain) const {
  if (activation_) activation_->stretch(agents, strain);
}

Index Biology::begin(AgentStore& agents) const {
  if (endothelium_) endothelium_->begin(agents);
  return activation_ ? activation_->activate(agents) : 0;
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
  if (matrix_) {
    const double meanActivation = activation_ ? activation_->meanOverStep() : 1;
    report.anyGrew |= matrix_->deposit(agents, meanActivation * step_);
  }
  division_->divide(agents, bonds, mothers);
  report.divisions = static_cast<Index>(mothers.size());
  if (activation_) activation_->decay(agents);
  if (endothelium_) endothelium_->mature(agents, step_);
  return report;
}

double Biology::endotheliumOnset() const {
  return endothelium_ ? endothelium_->onset() : std::numeric_limits<double>::infinity();
}

double Biology::endotheliumCompletion() const {
  return endothelium_ ? endothelium_->completion() : std::numeric_limits<double>::infinity();
}

double Biology::arrestingWss() const {
  return nitricOxide_ ? nitricOxide_->wssForNitricOxide(nitricOxide_->threshold())
                      : std::numeric_limits<double>::infinity();
}

}  // namespace restenosis
