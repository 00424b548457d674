#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/equilibrium/ActiveChunk.h"
#include "tissue/equilibrium/RelaxationParameters.h"

namespace restenosis {

/// What a step has to know of all agents together, summed chunk by chunk.
struct StepTotals {
  double power = 0;     ///< F . v
  double velocity = 0;  ///< v . M v, M the mass: see FireMinimiser
  double force = 0;     ///< F . F / M
  double stiffest = 0;  ///< largest stiffness [N/m]
  void join(const StepTotals& o) {
    power += o.power, velocity += o.velocity, force += o.force, stiffest = std::max(stiffest, o.stiffest);
  }
};

/// A method of reaching equilibrium. Every agent makes one step towards smaller forces: total() for all,
/// begin(), then step() for all.
///
/// The axial part of every force counts `axialForceFactor` times (T6): the axial mobility. It changes the
/// path, not the equilibrium.
class Minimiser {
 public:
  virtual ~Minimiser() = default;
  /// Adds the `count` agents of a chunk, changing none. For several threads.
  virtual void total(const ActiveChunk& agents, std::size_t count, StepTotals& totals) const = 0;
  virtual void begin(const StepTotals& totals) = 0;
  /// Sets their moves, of at most stepLimit x radius each. For several threads, each agent once a step.
  virtual void step(ActiveChunk& agents, std::size_t count, Moves& moves) const = 0;

 protected:
  /// Of the longest step that is allowed: shorter by more than single precision errs by.
  static constexpr double longestShare = 1 - 1e-6;
};

/// The minimiser called `parameters.minimiser`. Throws std::invalid_argument naming the known ones.
std::unique_ptr<Minimiser> makeMinimiser(const RelaxationParameters& parameters);
std::vector<std::string_view> minimiserNames();

}  // namespace restenosis
