#pragma once

#include "Minimiser.h"

namespace restenosis {

/// FIRE, the fast inertial relaxation engine (Bitzek et al. 2006, PRL 97:170201), with two changes:
///
/// - An agent's mass is the sum of the slopes of its pair forces, so that a soft contact and a stiff bond
///   follow at the same pace and the time step is a pure number (stable below sqrt(2) whatever the packing).
/// - An agent that moves against its force is slowed at once, and one that feels none is stopped. Otherwise
///   FIRE, which looks at the sum over all agents only, flings cells that have lost contact (`docs/model`),
///   and lets single ones swing long after the rest has settled.
class FireMinimiser : public Minimiser {
 public:
  static constexpr std::string_view name = "fire";
  explicit FireMinimiser(const MechanicsParameters& parameters);
  void step(const MinimiserView& view) override;

 private:
  double axialFactor_;
  double stepLimit_;
  double timeStep_;
  double mixing_;
  int downhillSteps_ = 0;
};

}  // namespace restenosis
