#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/agents/MarkedAgents.h"
#include "tissue/equilibrium/ActiveSet.h"
#include "tissue/equilibrium/Constraints.h"
#include "tissue/forces/AgentSpheres.h"
#include "tissue/forces/ForceField.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// Evaluates the forces on agents and knows of which of them the force may have changed since it was last
/// evaluated: these are stale. The residual of the others is known.
///
/// A force depends on positions and radii only: neither on the neighbour list nor on the number of threads,
/// and not on when it is evaluated.
class ForceCache {
 public:
  struct Settings {
    double leastStiffness = 0;        ///< that an agent is given [N/m]
    double skin = 0;                  ///< of the neighbour list [m]
    std::optional<FixedScale> mixed;  ///< the scale of mixed precision; nothing for double precision
  };

  /// All must outlive the object. Nothing is known before refresh().
  ForceCache(AgentStore& agents, const BondTable& bonds, const Constraints& constraints,
             const ForceField& field, NeighbourList& neighbours, const Settings& settings);

  /// Agents have been moved, grown or appended since the last call: brings neighbour list and copies up to
  /// date and marks those as stale on which one acts, or acted, that has changed. All are stale at first and
  /// where the agents are others or in another order. Throws std::invalid_argument for a radius that is not
  /// finite and above 0, or a bond table of another size.
  void refresh();

  /// Whether a relaxation may move agent i.
  bool isFree(Index i) const {
    return !agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut;
  }
  const BondTable& bonds() const { return bonds_; }
  /// AgentForce::residual of agent i when it was last evaluated.
  double residual(Index i) const { return residual_[i]; }
  std::uint64_t evaluations() const { return evaluations_; }  ///< forces evaluated, one an agent

  /// An active agent, of this radius, is here now.
  void move(Index i, const Vec3& position, float radius) { spheres_.move(i, position, radius); }
  /// Writes the place-th agent to the store: its position and stress, and its residual.
  void store(const ActiveSet& active, std::size_t place);
  /// Brings the neighbour list up to date; `moved` are the places of those of a small margin
  /// (NeighbourList::smallMargin).
  void updateNeighbours(ActiveSet& active, std::span<const Index> moved);

  /// Evaluates the forces on all active agents. Throws std::runtime_error naming an agent on which the force
  /// is not finite.
  void evaluate(ActiveSet& active);
  /// Evaluates the forces on these agents, in ascending order and none of them active, and sets their
  /// stresses. Throws likewise.
  std::vector<AgentForce> evaluate(std::span<const Index> agents);

  /// Whether the pair of agents i and j acts, or may have acted before i moved by `slack` [m].
  bool mayAct(Index i, Index j, double slack) const;
  /// Fetches the neighbours and bonds of agent i. Speed only: some 5 % of a relaxation.
  void prefetch(Index i) const { field_.pairs(agents_, neighbours_, bonds_).prefetch(i); }
  /// Agent i has moved by at most `slack` [m]: it is stale, and so are those on which it acts or acted.
  /// Several threads may call it.
  void markAround(Index i, double slack);
  /// Agents have moved: checks whether mixed precision still expresses them.
  void checkPrecision(std::span<const Index> moved);
  /// The stale agents, but active ones and struts, in ascending order. None is stale afterwards.
  std::vector<Index> extractStale(const ActiveSet& active);

 private:
  void requireSound() const;
  void refreshAll();
  /// Sets the forces on the first agents of a chunk by their loads.
  void setForces(ActiveChunk& chunk, std::span<const AgentLoad> loads) const;
  /// Lets chunkOf(begin, agents) return the chunk of each chunkSize of the agents, and sets the forces in it.
  template <class ChunkOf, class Done>
  void evaluateChunks(std::span<const Index> agents, const ChunkOf& chunkOf, const Done& done);

  AgentStore& agents_;
  const BondTable& bonds_;
  const Constraints& constraints_;
  const ForceField& field_;
  NeighbourList& neighbours_;
  Settings settings_;
  NeighbourRange range_;

  AgentSpheres spheres_;
  bool precisionHolds_ = false;  ///< AgentSpheres::precisionHolds, for all that has moved
  std::vector<float> residual_;
  MarkedAgents stale_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace restenosis
