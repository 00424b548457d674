#pragma once

#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {

/// Overdamped motion gamma dr/dt = F (T6), explicit Euler. The drag gamma is one for all agents and sets a
/// fictitious time only, so the time step is given by stability alone: dr = F / (largest stiffness x axial
/// factor), the stiffness being an upper bound of half the largest eigenvalue of the Hessian. A move beyond
/// the step limit is cut for the agent concerned.
class OverdampedMinimiser : public Minimiser {
 public:
  static constexpr std::string_view name = "overdamped";
  explicit OverdampedMinimiser(const RelaxationParameters& parameters);
  void total(const ActiveChunk& agents, std::size_t count, StepTotals& totals) const override;
  void begin(const StepTotals& totals) override;
  void step(ActiveChunk& agents, std::size_t count, Moves& moves) const override;

 private:
  double axialFactor_;
  double stepLimit_;
  double mobility_ = 0;  ///< across the axis [m/N]
};

}  // namespace restenosis
