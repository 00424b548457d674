#pragma once

#include <string>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/EndotheliumParameters.h"

namespace restenosis {

/// Nitric oxide that endothelium produces under wall shear stress w (model 7, ISR3D):
///
///     NO = a w                          for w <= w1,
///     NO = max(a w1, q2 w^2 + q1 w + q0) for w > w1,   NO in nmol/mm^3, w in Pa.
///
/// The published branches differ by 0.3 % at w1, and the parabola still falls there, by 0.1 %; the maximum
/// closes that gap, so that NO is continuous and never falls with w. It changes NO by at most 0.4 %,
/// between 1.05 and 1.08 Pa, far above the threshold.
class NitricOxide {
 public:
  /// Which parameters are wrong, if the parabola made NO fall with w; empty if not.
  static std::string problem(const EndotheliumParameters& parameters);
  /// Throws std::invalid_argument where NO would fall with w.
  explicit NitricOxide(const EndotheliumParameters& parameters);

  /// NO [nmol/mm^3] of a covered cell under `wss` [Pa]; 0 for a stress that is not positive.
  double concentration(double wss) const;
  /// The smallest wall shear stress [Pa] at which NO reaches `threshold` [nmol/mm^3]; 0.273 Pa for 0.001. A
  /// flow that stays on one side of it for every covered cell changes no cell's state.
  double wssForNitricOxide(double threshold) const;
  /// NO at or above this sends a cell to rest [nmol/mm^3].
  double threshold() const { return p_.nitricOxideThreshold; }

  /// Sets AgentStore::nitricOxide of every agent from the WSS it received: only covered SMC produce any, by
  /// the maturity of their endothelium. Where it has a reach, it then spreads (spreadNitricOxide).
  void apply(AgentStore& agents) const;

 private:
  EndotheliumParameters p_;
};

}  // namespace restenosis
