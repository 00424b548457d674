#pragma once

#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {

/// FIRE, the fast inertial relaxation engine (Bitzek et al. 2006, PRL 97:170201), with three changes:
///
/// - An agent's mass is the sum of the slopes of its pair forces, so that a soft contact and a stiff bond
///   follow at the same pace and the time step is a pure number: no eigenvalue is above 2.
/// - An agent that moves against its force is slowed at once, and one that feels none is stopped. Otherwise
///   FIRE, which has the sum over all agents only, flings cells that have lost contact (`docs/model`),
///   and lets single ones swing long after the rest has settled.
/// - Steering is bounded by what the stiffest agents bear. Unbounded it makes them swing while soft parts
///   drift, which holds the residual above a small tolerance.
class FireMinimiser : public Minimiser {
 public:
  static constexpr std::string_view name = "fire";
  explicit FireMinimiser(const RelaxationParameters& parameters);
  void total(const ActiveChunk& agents, std::size_t count, StepTotals& totals) const override;
  void begin(const StepTotals& totals) override;
  void step(ActiveChunk& agents, std::size_t count, Moves& moves) const override;

 private:
  Eigen::Vector3f mobilityShare_;  ///< mobility times stiffness, by axis
  Eigen::Vector3f massShare_;      ///< 1 / mobilityShare_
  double stepLimit_;
  double timeStep_;
  double mixing_;
  int downhillSteps_ = 0;
  double keep_ = 0;   ///< share of its velocity that an agent keeps in this step
  double steer_ = 0;  ///< what it gets along its force instead, over its mobility
};

}  // namespace restenosis
