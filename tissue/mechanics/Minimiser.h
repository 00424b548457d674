#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "AgentStore.h"
#include "MechanicsParameters.h"

namespace restenosis {

/// What a minimiser sees. Arrays are by agent, `step` is by place in `active`.
struct MinimiserView {
  std::span<const Index> active;      ///< agents that move, ascending
  std::span<const Vec3> force;        ///< residual force [N]
  std::span<const double> stiffness;  ///< sum of the slopes of an agent's pair forces, never 0 [N/m]
  std::span<const double> radius;     ///< [m]
  std::span<Vec3> velocity;           ///< the minimiser's own; zero for an agent that has just become active
  std::span<Vec3> step;               ///< output: how far to move [m], at most stepLimit x radius
};

/// A way to the equilibrium. Every agent takes one step towards smaller forces.
///
/// The axial part of every force counts `axialForceFactor` times (T6): the axial mobility. It changes the
/// way, not the equilibrium.
class Minimiser {
 public:
  virtual ~Minimiser() = default;
  virtual void step(const MinimiserView& view) = 0;
};

/// The minimiser called `parameters.minimiser`. Throws std::invalid_argument naming the known ones.
std::unique_ptr<Minimiser> makeMinimiser(const MechanicsParameters& parameters);
std::vector<std::string_view> minimiserNames();

}  // namespace restenosis
