#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/JaggedArray.h"
#include "tissue/neighbours/ListedAgent.h"
#include "tissue/neighbours/MovableGrid.h"
#include "tissue/neighbours/NeighbourRange.h"

namespace restenosis {

/// Verlet list: for each agent all others in range, in ascending order, so that a sum over an agent's
/// neighbours has one order whichever list within the skin is used. Each pair is listed for both agents.
///
/// The list is that of the agents as they were when their neighbours were last found, each at its own time
/// (ListedAgent). It holds every pair in range as long as no agent's displacement plus growth (times the
/// range's factor) exceeds half the skin. An update finds the neighbours of those agents only that come near
/// this.
class NeighbourList {
 public:
  /// Builds the list, in parallel. Throws std::invalid_argument naming the agent when a position is not
  /// finite.
  void build(const AgentStore& agents, const NeighbourRange& range);

  /// Which agents' neighbours an update changed.
  struct Change {
    bool all = false;
    std::vector<Index> agents;  ///< if not all, in ascending order
  };
  /// Makes the list hold every pair in range again: finds the neighbours of agents that were appended, moved
  /// or grew far, or became daughters. Builds it where these are many or agents were removed or reordered.
  /// Throws as build does.
  Change update(const AgentStore& agents, const NeighbourRange& range);
  /// The same where since the last build or update agents have moved and nothing else has changed. `moved`
  /// are, in ascending order, those with no more than smallMargin() left, and others at will. Costs what they
  /// cost.
  Change update(const AgentStore& agents, std::span<const Index> moved);

  /// Whether an update builds the list, where the neighbours of so many agents are to be found.
  bool isBuiltFor(std::size_t agents) const;

  std::span<const Index> of(Index i) const { return lists_[i]; }
  Index size() const { return static_cast<Index>(listed_.size()); }
  std::size_t pairCount() const { return lists_.elementCount() / 2; }
  /// Whether the agents of the list are still the first, in the same order.
  bool sameAgents(const AgentStore& agents) const;

  /// How far agent i at `position` may still move before, with another that has moved as far, a pair may be
  /// missing; below 0 one may be [m]. Radii are those of the last build or update.
  double margin(Index i, const Vec3& position) const {
    return listed_[i].allowance() - (position - listed_[i].position).norm();
  }
  /// The neighbours of agents with no more margin than this are found when those of others must be [m].
  double smallMargin() const;

 private:
  bool movedTooFar(const AgentStore& agents, Index i) const { return !(margin(i, agents.position(i)) >= 0); }
  bool hasSmallMargin(const AgentStore& agents, Index i) const {
    return !(margin(i, agents.position(i)) >= smallMargin());
  }
  void noteIds(const AgentStore& agents);
  /// Sets the allowances to present radii; returns the agents that need their neighbours found again, in
  /// ascending order.
  std::vector<Index> findStale(const AgentStore& agents);
  /// Finds the neighbours of these agents, or builds the list where they are many.
  Change renew(const AgentStore& agents, std::span<const Index> stale);
  /// Lists the agents in range of agent i, in ascending order.
  std::vector<Index> neighboursOf(Index i) const;
  /// Replaces the list of agent i, and edits those of neighbours it gained or lost, but for stale ones.
  /// Appends the agents with changed lists.
  void replace(Index i, std::span<const Index> found, std::vector<Index>& changed);

  NeighbourRange range_;
  std::vector<ListedAgent> listed_;
  std::uint64_t idHash_ = 0;  ///< of the ids of listed_
  JaggedArray<Index> lists_;
  std::optional<MovableGrid> grid_;    ///< of listed_; made by the first update
  double largestRadius_ = 0;           ///< of listed_ since the last build [m]
  std::vector<std::uint8_t> isStale_;  ///< scratch of renew()
};

}  // namespace restenosis
