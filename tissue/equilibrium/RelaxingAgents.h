#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/Chunks.h"
#include "tissue/equilibrium/AgentForces.h"
#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {

/// The agents during a relaxation: which of them are awake.
///
/// Awake agents move; all others sleep. Only those next to an agent that moved can have a force that changed,
/// so checking them from time to time is enough, and an iteration costs what the awake agents cost. A
/// widespread disturbance, as a step of deployment, wakes all.
class RelaxingAgents {
 public:
  /// All are asleep. `tolerance` is the residual above which an agent is not at rest. Without
  /// `sleeping` all are awake as soon as one is.
  RelaxingAgents(AgentForces& forces, double tolerance, bool sleeping);

  /// Sends everybody to sleep, computes all forces that may have changed and wakes the agents above the
  /// tolerance. `minimiser` moves them from now on.
  void begin(std::unique_ptr<Minimiser> minimiser);
  /// One step of the awake agents, then the forces on them.
  void advance();
  /// Computes the forces on all sleeping agents in range of an awake one that has come some way since this
  /// was last done, and wakes those clearly above the tolerance; tells whether there were any.
  bool wakeDisturbed();

  /// Puts the awake agents to sleep that have settled: at a residual of this share of the tolerance. Where
  /// many have not, nobody falls asleep.
  void retireSettled(double share);
  /// Whether all awake agents have.
  bool allSettled(double share);

  /// Wakes everybody; nobody falls asleep before the next begin().
  void wakeAll();

  bool allAsleep() const { return awake_.agents.empty(); }
  bool fewAreAwake() const { return areFew(awake_.size()); }
  bool mayAnyoneSleep() const { return sleeping_ && !keepAwake_; }
  /// Computes in double precision all forces that may have changed since it did so last, and wakes the agents
  /// above the tolerance; tells whether there were any.
  bool wakeAnyone();
  /// Largest residual of all free agents, as wakeAnyone() found it.
  double residual() const;
  /// The agent farthest from rest of those that are awake, of which there is one.
  Index farthestFromRest() const;

 private:
  /// The sleepers in range of an awake agent that has come some way, whose ways begin anew; in ascending
  /// order.
  std::vector<Index> sleepersBesideMovers();
  /// Appends an agent to `found` and marks it, if it is wanted(i) and not marked yet. May be called from
  /// several threads.
  template <class Wanted>
  void take(Index i, const Wanted& wanted, std::vector<Index>& found);
  /// These agents, which are all that are marked, in ascending order and no more marked.
  std::vector<Index> unmarkAll(std::vector<Index> marked);
  /// Whether an agent, or all of those with this largest residual, has settled at this share of the
  /// tolerance.
  bool settled(double residual, double share) const { return residual <= share * tolerance_; }
  /// Whether a disturbance of so many is a local one.
  bool areFew(std::size_t agents) const;
  /// An agent that is to wake, and the force on it.
  struct Disturbed {
    Index agent;
    AgentForce now;
  };
  /// Those found among agents that were looked at, one list for each piece of chunkSize of them.
  using DisturbedPieces = std::vector<std::vector<Disturbed>>;
  static DisturbedPieces piecesOf(std::size_t agents) {
    return DisturbedPieces((agents + chunkSize - 1) / chunkSize);
  }
  /// Wakes them; all, if many are awake then. Returns whether there were any.
  bool wakeDisturbed(DisturbedPieces disturbed);
  void wakeAllAsleep();
  /// In ascending order. They set out with the forces of now, not of when they were last looked at.
  void wakeWithForces(std::span<const Index> sleepers);
  /// In ascending order; no force on them is known.
  void wake(std::span<const Index> sleepers);
  /// Where an agent that is awake stands among those.
  std::size_t placeOf(Index awake) const;
  /// What the forces on awake agents amount to.
  struct Sight {
    StepTotals totals;
    double residual = 0;  ///< the largest
    void join(const Sight& other);
  };
  void look(std::size_t begin, std::size_t end, Sight& part);
  /// Of all awake agents; found when their forces are computed, or now.
  const Sight& sight();
  AgentForces& forces_;
  double tolerance_;
  bool sleeping_;
  bool keepAwake_ = false;

  std::unique_ptr<Minimiser> minimiser_;
  std::vector<std::uint8_t> isAwake_;
  MovingAgents awake_;
  std::optional<Sight> sight_;        ///< nothing where awake_ or its forces have changed since
  std::vector<std::uint8_t> marked_;  ///< scratch
};

}  // namespace restenosis
