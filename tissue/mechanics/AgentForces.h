#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "AgentMotion.h"
#include "AgentStore.h"
#include "BondTable.h"
#include "Constraint.h"
#include "ForceField.h"
#include "NeighbourList.h"

namespace restenosis {

/// The forces on agents of which few move: what they were when last computed, and whose may have changed
/// since. Positions are changed through it, so that its copies of them, the neighbour list and the table of
/// pairs follow.
///
/// On the way forces are in mixed precision where that is asked for and holds; evaluateExactly() is always in
/// double precision. What is computed depends on positions and radii only, neither on the neighbour list nor
/// on the number of threads.
class AgentForces {
 public:
  struct Settings {
    double softest = 0;               ///< least stiffness an agent is given [N/m]
    double firm = 0;                  ///< stiffness of contacts that hold a daughter firmly [N/m]
    double skin = 0;                  ///< how far beyond contact the neighbour list looks [m]
    std::optional<FixedScale> scale;  ///< of mixed precision; nothing for double precision
  };

  /// `neighbours` is brought up to date, at little cost where it is nearly so. All must outlive the object.
  /// Projects every free agent onto its constraints; no force is computed yet. Throws std::invalid_argument
  /// for a radius that is not finite and above 0, or a bond table of another size.
  AgentForces(AgentStore& agents, const BondTable& bonds, std::span<const Constraint* const> constraints,
              const ForceField& field, NeighbourList& neighbours, const Settings& settings);

  /// The same as making a new object, where since evaluateExactly() agents have moved, grown or been appended
  /// and nothing else has changed: forces known to be as they were are kept.
  void refresh();

  Index size() const { return agents_.size(); }
  bool isFree(Index i) const;
  const std::vector<Index>& free() const { return free_; }  ///< in ascending order
  const AgentStore& agents() const { return agents_; }
  const NeighbourList& neighbours() const { return neighbours_; }
  const BondTable& bonds() const { return bonds_; }
  /// By agent. Velocities are the caller's to set; those of agents not seen before are zero.
  const std::vector<AgentMotion>& motion() const { return motion_; }
  std::span<AgentMotion> motion() { return motion_; }
  /// The force on an agent, as last computed [N].
  double residual(Index i) const { return motion_[i].force.norm(); }
  /// The same, for a daughter times `firm` over the stiffness of her contacts, taken as `softest` at least,
  /// where that is above 1 [N].
  double restlessness(Index i) const { return motion_[i].restlessness; }
  std::uint64_t evaluations() const { return evaluations_; }  ///< forces computed, one an agent

  /// Moves an agent, named to startMoving before, to the nearest place its constraints allow. Returns whether
  /// the lists must be updated. May be called from several threads, for different agents.
  bool moveTo(Index i, const Vec3& position);
  /// Brings the lists up to date after the agents `moved` did, in ascending order; appends to `relisted`
  /// whose partners changed.
  void updateLists(std::span<const Index> moved, std::vector<Index>& relisted);

  /// These agents move from now on, until evaluateExactly() names others.
  void startMoving(std::span<const Index> agents);
  /// Is told that the forces on the agents subset[begin] to subset[end - 1] have been computed.
  using Look = std::function<void(std::size_t begin, std::size_t end)>;
  /// The forces on these agents, in ascending order. `look` is called for pieces of chunkSize agents, from
  /// several threads.
  void evaluate(std::span<const Index> subset, const Look& look = {});
  /// The forces on these agents have been computed in mixed precision; evaluateExactly() is to do them again.
  void doubt(std::span<const Index> agents);
  /// Computes in double precision all forces that may have changed since it did so last, and returns on whom,
  /// in ascending order. From then on the agents `moving` move.
  std::vector<Index> evaluateExactly(std::span<const Index> moving);

 private:
  /// Knows nothing yet: every force is unsure.
  void start();
  /// Puts every free agent where its constraints allow.
  void project();
  /// Whether agent i is within what mixed precision can express.
  bool fits(Index i) const;
  bool allFit(std::span<const Index> agents) const;
  /// Whether agent i is not where and as large as its copy.
  bool changed(Index i) const;
  /// Makes the copy agent i.
  void take(Index i);
  /// Whether agent i, were it there and so large, could act on agent j, which has not moved.
  bool mayAct(Index i, const Vec3& position, double radius, Index j) const;
  /// Whether agent i may act on agent j, which has not moved, or acted on it at the time of
  /// evaluateExactly().
  bool mayHaveActed(Index i, Index j) const;
  /// The forces on these agents and on those they act on or acted on at the time of evaluateExactly() are
  /// unsure.
  void doubtAround(std::span<const Index> agents);
  void packAll();
  void buildPairs();
  bool marksDaughters() const { return range_.daughterFactor > range_.factor; }
  template <class Spheres>
  void evaluate(const Spheres& spheres, std::span<const Index> subset, const Look& look);

  AgentStore& agents_;
  const BondTable& bonds_;
  std::vector<const Constraint*> constraints_;
  const ForceField& field_;
  NeighbourList& neighbours_;
  Settings settings_;
  NeighbourRange range_;

  std::optional<FixedScale> scale_;  ///< settings_.scale unless an agent does not fit
  bool outgrown_ = false;            ///< an agent did not fit when it was last looked at
  PairTable pairs_;
  std::vector<FixedSphere> fixed_;  ///< in mixed precision only
  std::vector<Sphere> spheres_;     ///< in mixed precision of the time of evaluateExactly()
  std::vector<AgentMotion> motion_;
  std::vector<Index> free_;
  std::vector<Index> moving_;  ///< since the last exact evaluation, in no particular order
  std::vector<std::uint8_t> isMoving_;
  /// Whose force may have changed since, beside those of and next to moving_.
  std::vector<std::uint8_t> unsure_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace restenosis
