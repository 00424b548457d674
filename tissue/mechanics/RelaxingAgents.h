#pragma once

#include <optional>
#include <span>
#include <vector>

#include "AgentStore.h"
#include "BondTable.h"
#include "Constraint.h"
#include "ForceField.h"
#include "Minimiser.h"

namespace restenosis {

/// The agents during one relaxation: which of them are awake, the forces on them, and the neighbour list.
///
/// Awake agents move; all others sleep. Only those next to an agent that moved can have a force that changed,
/// so checking them from time to time is enough, and an iteration costs what the awake agents cost. A
/// widespread disturbance, as a step of deployment, wakes all.
class RelaxingAgents {
 public:
  /// Projects every free agent onto its constraints, computes all forces and wakes the agents above
  /// `tolerance` [N]. `neighbours` is brought up to date, at little cost where it is nearly so; `skin` [m] is
  /// how far beyond contact it looks. On the way forces are computed in mixed precision if `scale` says how;
  /// who is at rest at the beginning and at the end is decided in double precision.
  RelaxingAgents(AgentStore& agents, const BondTable& bonds, std::span<const Constraint* const> constraints,
                 const ForceField& field, double softest, double tolerance, NeighbourList& neighbours,
                 double skin, std::optional<FixedScale> scale);

  /// One step of the awake agents, then the forces on them.
  void advance(Minimiser& minimiser);
  /// Computes the forces on all sleeping agents next to an awake one and wakes those clearly above the
  /// tolerance; tells whether there were any.
  bool wakeDisturbed();

  /// Where few of the awake agents have a residual above `settled` [N], puts those to sleep that have come to
  /// rest away from them.
  void retireQuiet(double settled);

  bool allAsleep() const { return awake_.empty(); }
  /// Computes in double precision all forces that may have changed since it did so last, and wakes the agents
  /// above the tolerance; tells whether there were any.
  bool wakeAnyone();
  /// Largest residual of the awake agents [N].
  double awakeResidual() const;
  /// Largest residual of all free agents, as last computed [N].
  double residual() const;
  /// Agent with the largest residual of all.
  Index worstAgent() const;
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  bool isFree(Index i) const;
  Vec3 projected(Index i, Vec3 position) const;
  void place(Index i, const Vec3& position);
  void updatePairs();
  /// Forces on the agents of `subset`, in mixed precision where it is used.
  void evaluate(std::span<const Index> subset);
  /// In double precision, all forces that may have changed since this was done last.
  void evaluateExactly();
  template <class Spheres>
  void evaluate(const Spheres& spheres, std::span<const Index> subset);
  /// Marks the agents that touch or are bonded to one of `agents`, are not marked yet and `wanted`; returns
  /// them.
  template <class Wanted>
  std::vector<Index> markPartners(const std::vector<Index>& agents, Wanted&& wanted);
  /// Wakes the restless and those they touch or are bonded to, so that a disturbance does not have to wait
  /// for its surroundings; all, if many are awake then.
  void wakeAround(const std::vector<Index>& restless);
  void wake(const std::vector<Index>& sleepers);

  AgentStore& agents_;
  const BondTable& bonds_;
  std::span<const Constraint* const> constraints_;
  const ForceField& field_;
  double softest_;    ///< least stiffness an agent is given [N/m]
  double tolerance_;  ///< [N]

  NeighbourList& neighbours_;
  NeighbourRange range_;
  PairTable pairs_;
  std::optional<FixedScale> scale_;
  std::vector<FixedSphere> fixed_;  ///< in mixed precision only
  std::vector<Sphere> spheres_;     ///< in double precision only
  std::vector<Vec3> force_;         ///< what constraints leave of the load
  std::vector<double> stiffness_;   ///< of the load, at least softest_
  std::vector<double> residual_;    ///< length of force_, 0 for agents that are not free
  std::vector<Vec3> velocity_;
  std::vector<std::uint8_t> isAwake_;
  std::vector<Index> free_, awake_;
  std::vector<Index> moved_;  ///< who has been awake since the last exact evaluation, some repeatedly
  std::vector<std::uint8_t>
      unsure_;                   ///< whose force may have changed since, beside those of and next to moved_
  std::vector<Index> relisted_;  ///< whose neighbours have changed since sleepers were looked at
  std::vector<std::uint8_t> marked_;  ///< scratch of wakeDisturbed
  std::vector<Vec3> step_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace restenosis
