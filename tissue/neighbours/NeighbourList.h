#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "AgentStore.h"

namespace restenosis {

/// Who may interact: centres closer than factor (R_i + R_j) + skin.
struct NeighbourRange {
  double factor = 1;          ///< of pairs in general
  double daughterFactor = 1;  ///< of pairs with at least one daughter, which cohere across a gap
  double skin = 0;            ///< [m]; how far two agents together may move before the list misses a pair
};

/// Verlet list: for each agent all others in range, in ascending order, so that a sum over an agent's
/// neighbours has one order whichever list within the skin it is taken from. Each pair stands at both of its
/// agents.
class NeighbourList {
 public:
  /// Makes the list, in parallel. Throws std::invalid_argument naming the agent when a position is not
  /// finite.
  void build(const AgentStore& agents, const NeighbourRange& range);

  std::span<const Index> of(Index i) const {
    return {neighbours_.data() + start_[i], neighbours_.data() + start_[i + 1]};
  }
  Index size() const { return start_.empty() ? 0 : static_cast<Index>(start_.size() - 1); }
  std::size_t pairCount() const { return neighbours_.size() / 2; }

  /// Where agent i was when the list was made [m].
  const Vec3& positionAtBuild(Index i) const { return positions_[i]; }
  /// True if agent i has gone so far that, with another that has gone as far, a pair may be missing.
  bool movedTooFar(Index i, const Vec3& position) const {
    return (position - positions_[i]).squaredNorm() > largestMove_ * largestMove_;
  }
  /// True if any agent has moved too far, or agents came or went.
  bool needsRebuild(const AgentStore& agents) const;

 private:
  std::vector<std::size_t> start_;
  std::vector<Index> neighbours_;
  std::vector<Vec3> positions_;
  double largestMove_ = 0;
};

}  // namespace restenosis
