#pragma once

#include <cmath>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/RowPool.h"
#include "tissue/neighbours/MovableGrid.h"

namespace restenosis {

/// Who may interact: centres closer than factor (R_i + R_j) + skin.
struct NeighbourRange {
  double factor = 1;          ///< of pairs in general
  double daughterFactor = 1;  ///< of pairs with at least one daughter, which cohere across a gap
  double skin = 0;            ///< [m]; how far two agents together may move before the list misses a pair

  bool operator==(const NeighbourRange&) const = default;
};

/// Verlet list: for each agent all others in range, in ascending order, so that a sum over an agent's
/// neighbours has one order whichever list within the skin it is taken from. Each pair stands at both of its
/// agents.
///
/// An update costs what has changed: the rows of the agents looked up and of their neighbours.
///
/// The list is that of the agents as they stood when they were last looked up, each at its own time: their
/// anchors. It holds every pair in range as long as no agent's move plus growth (times the range's factor)
/// exceeds half the skin.
class NeighbourList {
 public:
  /// Makes the list, in parallel. Throws std::invalid_argument naming the agent when a position is not
  /// finite.
  void build(const AgentStore& agents, const NeighbourRange& range);

  /// Which agents' neighbours an update changed.
  struct Change {
    bool all = false;
    std::vector<Index> agents;  ///< if not all, in ascending order
  };
  /// Makes the list hold every pair in range again at the least cost: looks up only the agents that were
  /// appended, went or grew far, or became daughters, and builds anew where those are many or agents were
  /// removed or reordered. Throws as build does.
  Change update(const AgentStore& agents, const NeighbourRange& range);
  /// The same where since the last build or update nothing happened but that agents moved; `moved` are, in
  /// ascending order, those with less than smallMargin() left, and others at will. Costs what they cost.
  Change update(const AgentStore& agents, std::span<const Index> moved);

  /// Whether an update looks so many agents up instead of building the list anew.
  bool worthLookingUp(std::size_t agents) const;

  std::span<const Index> of(Index i) const { return rows_[i]; }
  /// Brings into the cache what of() these agents refers to. Speed only.
  void readAhead(std::span<const Index> agents) const { rows_.readAhead(agents); }
  Index size() const { return static_cast<Index>(anchors_.size()); }
  std::size_t pairCount() const { return rows_.elementCount() / 2; }
  /// Whether the agents of the list are still the first, in the same order.
  bool sameAgents(const AgentStore& agents) const;

  /// How far agent i at `position` may still go before, with another that has gone as far, a pair may be
  /// missing; below 0 one may be [m]. Radii are those of the last build or update.
  double margin(Index i, const Vec3& position) const {
    return anchors_[i].allowance() - (position - anchors_[i].position).norm();
  }
  /// Agents with no more room than this are looked up when others must be [m].
  double smallMargin() const;

 private:
  /// An agent as it was when it was last looked up. Half a cache line: a search reads those of many agents.
  /// Single precision errs to the safe side: the list may hold a pair too many, none too few.
  class Anchor {
   public:
    Anchor() = default;
    Anchor(const Vec3& place, double agentRadius, bool isDaughter, double allowed);
    void allow(double distance);  ///< sets the allowance, not below 0

    Vec3 position;
    bool daughter() const { return std::signbit(radius_); }
    double radius() const { return std::abs(radius_); }  ///< [m]
    double allowance() const {
      return allowance_;
    }  ///< how far it may go from there, less what it has grown since [m]

   private:
    float radius_ = 0;  ///< below 0 for a daughter
    float allowance_ = 0;
  };
  static_assert(sizeof(Anchor) == 32);
  static Anchor anchorOf(const AgentStore& agents, Index i, const NeighbourRange& range);
  /// Whether agent i of `agents` has no room.
  bool movedTooFar(const AgentStore& agents, Index i) const { return !(margin(i, agents.position(i)) >= 0); }
  /// Whether it is to be looked up when others must be.
  bool hasSmallMargin(const AgentStore& agents, Index i) const {
    return !(margin(i, agents.position(i)) >= smallMargin());
  }
  /// Sets the allowances to present radii; returns whom to look up, in ascending order.
  std::vector<Index> findStale(const AgentStore& agents);
  /// Looks up the agents `names`; returns whose rows changed, in ascending order.
  std::vector<Index> lookUp(const AgentStore& agents, std::span<const Index> names);
  /// Makes found[k] the agents in range of the k-th of `agents`, in ascending order.
  void findInRange(std::span<const Index> agents, std::span<std::vector<Index>> found) const;
  /// A neighbour that a row gains, or loses if it has it.
  struct Edit {
    Index row, neighbour;
    auto operator<=>(const Edit&) const = default;
  };
  /// What is done to rows by several threads, and what is left to one of them.
  struct Rows {
    std::vector<Index> changed;                               ///< in ascending order
    std::vector<Edit> edits;                                  ///< of other rows, not done yet, sorted
    std::vector<std::pair<Index, std::vector<Index>>> grown;  ///< those without room, not set yet
  };
  /// Sets the rows of the agents `names`, of whom those from `known` on are new. The edits are of the rows of
  /// agents that are not among them.
  Rows setRowsOf(std::span<const Index> names, Index known);
  /// Sets the rows that these sorted edits are of.
  Rows setRowsBy(std::span<const Edit> edits);
  /// What f(begin, end, rows) does to rows for pieces of `size` of `count` elements.
  template <class F>
  static Rows inPieces(std::size_t count, std::ptrdiff_t size, const F& f);
  /// Sets the row of agent i, or notes that it has no room.
  void setRow(Index i, const std::vector<Index>& row, Rows& rows);
  /// Appends what `row`, agent i's neighbours now, has and has not of those listed, as edits of their rows,
  /// but for those that are being looked up themselves; tells whether there is any difference.
  bool noteDifference(Index i, const std::vector<Index>& row, std::vector<Edit>& edits) const;
  /// The row that these edits, all of one and sorted, make of the one listed.
  void apply(std::span<const Edit> edits, std::vector<Index>& row) const;

  /// Notes the names of the agents from `first` on.
  void noteNames(const AgentStore& agents, Index first);

  NeighbourRange range_;
  std::vector<Anchor> anchors_;
  std::vector<std::uint64_t> names_;  ///< of each piece of agents, in their order: a hash
  RowPool<Index> rows_;
  std::optional<MovableGrid> grid_;  ///< of the anchors; made when agents are first looked up
  double largestRadius_ = 0;         ///< of all anchors since the last build [m]
  std::vector<std::uint8_t> stale_;  ///< scratch of lookUp
};

}  // namespace restenosis
