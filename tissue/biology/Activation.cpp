#include "tissue/biology/Activation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/biology/CellCycle.h"

namespace restenosis {

double Activation::byStretch(double strain) const {
  if (strain >= p_.stretchFull) return 1;
  if (strain <= p_.stretchOnset) return 0;
  return (strain - p_.stretchOnset) / (p_.stretchFull - p_.stretchOnset);
}

void Activation::stretch(AgentStore& agents, std::span<const double> strain) const {
  for (Index i = 0; i < agents.size(); ++i)
    agents.activation.set(i, static_cast<float>(byStretch(strain[i])));
}

Index Activation::activate(AgentStore& agents) const {
  Index byStretchAlone = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    if (!CellCycle::cycles(agents, i)) {
      agents.activation.set(i, 0);
    } else if (agents.has(i, synthetic)) {
      agents.activation.set(i, 1);
    } else if (agents.activation[i] > 0) {
      agents.set(i, synthetic, true);
      ++byStretchAlone;
    }
  }
  return byStretchAlone;
}

double Activation::entry(const AgentStore& agents, Index cell, double duration, std::uint32_t step) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double hazard = p_.entryRate * agents.activation[cell];
  if (!(hazard > 0)) return never;
  RandomStream random(seed_, agents.id[cell], step, RandomPurpose::activation);
  // The integral of the hazard up to the entry is exponentially distributed
  const double integral = -std::log1p(-random.uniform());
  const double whole = hazard * p_.decayTime;
  if (integral >= -whole * std::expm1(-duration / p_.decayTime)) return never;
  return std::min(duration, -p_.decayTime * std::log1p(-integral / whole));
}

void Activation::decay(AgentStore& agents) const {
  const double factor = std::exp(-step_ / p_.decayTime);
  forEachInChunks(agents.size(), [&](std::size_t i) {
    agents.activation.set(i, static_cast<float>(factor * agents.activation[i]));
  });
}

double Activation::meanOverStep() const {
  const double x = step_ / p_.decayTime;
  return -std::expm1(-x) / x;
}

}  // namespace restenosis
