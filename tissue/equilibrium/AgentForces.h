#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/equilibrium/AgentSpheres.h"
#include "tissue/equilibrium/Constraint.h"
#include "tissue/equilibrium/MovingAgents.h"
#include "tissue/equilibrium/UnsureForces.h"
#include "tissue/forces/ForceField.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// The forces on agents of which few move, and whose may have changed since they were computed. Positions are
/// changed through it, so that its copies of them, the neighbour list and the rows of pairs follow; the
/// store learns of them by place() and whenever all forces that may have changed are asked for.
///
/// On the way forces are in mixed precision where that is asked for and holds; evaluateExactly() is always in
/// double precision. What is computed depends on positions and radii only, neither on the neighbour list nor
/// on the number of threads.
class AgentForces {
 public:
  struct Settings {
    double softest = 0;               ///< least stiffness an agent is given [N/m]
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
  /// AgentForce::residual of an agent, as evaluateExactly() last computed it.
  double residual(Index i) const { return residual_[i]; }
  std::uint64_t evaluations() const { return evaluations_; }  ///< forces computed, one an agent

  /// Agent i of the store.
  AgentMotion motionOf(Index i) const;
  /// These agents move from now on, until evaluateExactly() names others.
  void startMoving(std::span<const Index> agents) { unsure_.startMoving(agents); }
  /// Moves the agents of a piece, named to startMoving, to the nearest places their constraints allow.
  /// Appends the places in the piece of those that are cramped: to be named to updateLists. May be called
  /// from several threads, for different pieces.
  void move(std::span<const Index> agents, MotionPiece& piece, const Moves& moves,
            std::vector<Index>& cramped);
  /// Tells the store where an agent is.
  void place(Index i, const Vec3& position) { agents_.setPosition(i, position); }
  /// Brings the lists up to date after these agents did move; `cramped` are the places among them, ascending,
  /// of those that are.
  void updateLists(MovingAgents& moving, std::span<const Index> cramped);
  /// Whether the k-th agent of a piece is in range of agent j, which is where the store has it.
  bool inRange(const MotionPiece& piece, std::size_t k, Index j) const;

  /// Is told that the forces on the agents [begin, end) have been computed.
  using Look = std::function<void(std::size_t begin, std::size_t end)>;
  /// Sets the forces on agents that move. `look` is called for pieces of chunkSize agents, from several
  /// threads.
  void evaluate(MovingAgents& moving, const Look& look);
  /// Is told the force on the k-th of some agents, which is agent i.
  using Take = std::function<void(std::size_t k, Index i, const AgentForce& force)>;
  /// The forces on agents that are where the store has them, in ascending order, and their pressures there.
  /// `take` is called from several threads, by one for each piece of chunkSize agents and in their order.
  void evaluate(std::span<const Index> resting, const Take& take);
  /// The forces on these agents have been computed in mixed precision; evaluateExactly() is to do them again.
  void doubt(std::span<const Index> agents) { unsure_.mark(agents); }
  /// Tells the store where the agents that move are, and returns whose forces may have changed since
  /// evaluateExactly() computed them, in ascending order.
  std::vector<Index> unsure(const MovingAgents& moving);
  /// Computes the forces on `unsure`, all that are, in double precision, and takes them as evaluate() does;
  /// and the pressures of fixed agents.
  /// From then on the agents `moving` move.
  void evaluateExactly(std::span<const Index> unsure, std::span<const Index> moving, const Take& take);

 private:
  /// Knows nothing yet: every force is unsure.
  void start();
  /// Puts agent i, if it is free, where its constraints allow.
  void project(Index i);
  /// Who acts on whom now.
  PairSource pairs() const;
  /// Makes the rows of these agents.
  void layOut(MovingAgents& moving) const;
  /// Does so anew for those of them, if any, that are among `changed`, which are in ascending order.
  void layOutAnew(MovingAgents& moving, std::span<const Index> changed) const;
  void placeAll(const MovingAgents& moving);
  /// The room that an agent has, in single precision, which errs to the safe side [m].
  float leashOf(Index i, const Vec3& position) const;
  /// How far such an agent may go before any constraint acts on it, likewise.
  float roomOf(AgentKind kind, double radius, const Vec3& position) const;
  /// Sets the forces on the agents of a piece by their loads.
  void setForces(MotionPiece& piece, std::span<const AgentLoad> loads) const;
  /// Sets the loads of a piece of `agents` whose rows are not kept.
  template <class Spheres>
  void evaluateOnce(const Spheres& spheres, std::span<const Index> piece, std::span<AgentLoad> loads) const;
  template <class Spheres>
  void evaluateResting(const Spheres& spheres, std::span<const Index> subset, const Take& take);
  /// Lets set(begin, loads) set the forces on the piece of `agents` that begins there, and return it, its
  /// loads being what loadsOf(begin, loads) makes them. Throws std::runtime_error naming one on which the
  /// force is not finite.
  template <class LoadsOf, class Set>
  void evaluatePieces(std::span<const Index> agents, const LoadsOf& loadsOf, const Set& set);
  /// Sets the pressures of those fixed agents of whom something may have changed.
  void pressHeld();

  AgentStore& agents_;
  const BondTable& bonds_;
  std::vector<const Constraint*> constraints_;
  const ForceField& field_;
  NeighbourList& neighbours_;
  Settings settings_;
  NeighbourRange range_;

  AgentSpheres spheres_;
  UnsureForces unsure_;           ///< since evaluateExactly()
  std::vector<double> residual_;  ///< of the time of evaluateExactly()
  std::vector<Index> free_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace restenosis
