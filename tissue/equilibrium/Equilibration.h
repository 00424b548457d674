#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "tissue/agents/MarkedAgents.h"
#include "tissue/equilibrium/ActiveSet.h"
#include "tissue/equilibrium/Constraints.h"
#include "tissue/equilibrium/ForceCache.h"
#include "tissue/equilibrium/Minimiser.h"
#include "tissue/equilibrium/RelaxationParameters.h"
#include "tissue/equilibrium/RelaxationReport.h"

namespace restenosis {

/// Iterates agents to equilibrium, and goes on from what is known of the forces when it is asked again.
///
/// Only the active set is moved: agents with a residual above the tolerance, until theirs is far below. The
/// force on an inactive agent changes only where a neighbour moves, so reviewing the neighbours of the active
/// set from time to time is enough, and an iteration costs what the active agents cost. All that may have
/// changed are verified before the iteration ends. A disturbance of many agents, as a step of deployment,
/// activates all.
class Equilibration {
 public:
  /// All must outlive the object.
  Equilibration(AgentStore& agents, const BondTable& bonds, std::span<const Constraint* const> constraints,
                const ForceField& field, NeighbourList& neighbours, const ForceCache::Settings& settings,
                const RelaxationParameters& parameters);
  Equilibration(const Equilibration&) = delete;
  Equilibration& operator=(const Equilibration&) = delete;

  /// Moves the free agents until the residual of none is above the tolerance, or for `maximumIterations`.
  /// `beforeIteration` may throw to end it.
  RelaxationReport run(const std::function<void()>& beforeIteration);
  /// The active agent of the largest residual, after a run that did not converge.
  Index worstAgent() const;

 private:
  /// Begins with an empty active set; returns whether any agent is above the tolerance.
  bool begin();
  /// Moves the active agents by a step of the minimiser.
  void step();
  /// Moves the agents of a chunk as far as constraints allow; appends the places, from `first` on, of those
  /// that have a small margin to the next update of the neighbour list.
  void move(ActiveChunk& chunk, std::span<const Index> agents, const Moves& moves, std::size_t first,
            std::vector<Index>& small);
  void updateNeighbours(std::span<const Index> smallMargins);

  /// Evaluates the inactive neighbours of active agents that have moved, and activates those above the
  /// tolerance. Returns whether there were any.
  bool review();
  /// Evaluates all inactive agents on which the force may have changed, and activates those above the
  /// tolerance. Returns whether no agent is above it.
  bool verify();
  /// Activates those of the agents with a force above the tolerance, or all free agents if these are many.
  bool activateDisturbed(std::span<const Index> agents, std::span<const AgentForce> forces);
  void activateAll();
  void activate(std::span<const Index> agents, std::span<const AgentForce> forces);
  /// Deactivates the agents that have converged, unless many have not.
  void deactivateConverged();

  /// Whether the residual of all active agents is as small as the iteration aims at.
  bool activeConverged() const { return largestActiveResidual() <= aim_; }
  float largestActiveResidual() const;
  double largestResidual() const;
  /// Whether so many agents are few enough for an active set.
  bool isLocal(std::size_t agents) const;
  bool mayDeactivate() const { return parameters_.activeSet && !allForGood_; }

  AgentStore& agents_;
  Constraints constraints_;
  RelaxationParameters parameters_;
  double aim_;  ///< residual to which active agents are brought
  NeighbourList& neighbours_;
  ForceCache forces_;
  ActiveSet active_;
  std::unique_ptr<Minimiser> minimiser_;
  std::vector<Index> free_;  ///< in ascending order
  bool allForGood_ = false;  ///< whether no agent is to be deactivated in this run
  MarkedAgents reviewed_;    ///< scratch of review()
};

}  // namespace restenosis
