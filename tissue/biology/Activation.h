#pragma once

#include <cstdint>
#include <span>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/ActivationParameters.h"

namespace restenosis {

/// Which cells have been told to grow, and for how long (model 5). A cell's activation A, in [0, 1], is set
/// by injury and stretch, inherited by daughters, and decays as dA/dt = -A / decayTime. An activated cell at
/// rest that nothing holds enters G1 with the hazard entryRate A, so that cells enter one after another and
/// the tissue grows less and less as activation decays.
class Activation {
 public:
  /// `step` [s] is the biological step.
  Activation(const ActivationParameters& parameters, std::uint64_t seed, double step)
      : p_(parameters), seed_(seed), step_(step) {}

  /// The wall has been deployed: activates its cells by `strain`, that around the vessel at each agent.
  void stretch(AgentStore& agents, std::span<const double> strain) const;
  /// The wall has been injured: activates synthetic cells fully; the others that stretch has activated become
  /// synthetic. Returns how many these are. Agents that do not cycle are not activated.
  Index activate(AgentStore& agents) const;
  /// Activation by a strain: 0 up to stretchOnset, 1 from stretchFull on, linear between.
  double byStretch(double strain) const;

  /// When the cell enters G1 of the next `duration` [s], in which it is held by nothing; infinity for not
  /// then. Drawn by (seed, id, step), exactly by the hazard of the decaying activation.
  double entry(const AgentStore& agents, Index cell, double duration, std::uint32_t step) const;
  /// A biological step has passed.
  void decay(AgentStore& agents) const;
  /// Mean activation over the next step, over that at its start.
  double meanOverStep() const;

 private:
  ActivationParameters p_;
  std::uint64_t seed_;
  double step_;
};

}  // namespace restenosis
