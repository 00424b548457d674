#pragma once

#include <cmath>

#include "tissue/agents/AgentStore.h"
#include "tissue/neighbours/NeighbourRange.h"

namespace restenosis {

/// An agent as it was when its neighbours were last found. Half a cache line: a search reads those of many
/// agents. Single precision errs to the safe side: the list may hold a pair too many, none too few.
class ListedAgent {
 public:
  ListedAgent() = default;
  /// Throws std::invalid_argument naming the agent when its position is not finite.
  ListedAgent(const AgentStore& agents, Index i, const NeighbourRange& range);

  Vec3 position;  ///< [m]
  bool daughter() const { return std::signbit(radius_); }
  double radius() const { return std::abs(radius_); }  ///< [m]
  /// How far it may move from there before the list may miss a pair, less what it has grown since [m].
  double allowance() const { return allowance_; }
  void setAllowance(double distance);  ///< not below 0

 private:
  float radius_ = 0;  ///< below 0 for a daughter
  float allowance_ = 0;
};
static_assert(sizeof(ListedAgent) == 32);

/// Whether two agents are neighbours.
inline bool inRange(const NeighbourRange& range, const ListedAgent& a, const ListedAgent& b) {
  const Vec3 apart = a.position - b.position;
  const bool daughter = (int{a.daughter()} | int{b.daughter()}) != 0;  // no branch to be guessed wrong
  const double factor = daughter ? range.daughterFactor : range.factor;
  const double reach = factor * (a.radius() + b.radius()) + range.skin;
  return apart.squaredNorm() <= reach * reach;
}

/// Distance within which all neighbours of an agent are, where no radius is above the largest one [m].
inline double reachOf(const NeighbourRange& range, const ListedAgent& agent, double largestRadius) {
  return range.largestFactor() * (agent.radius() + largestRadius) + range.skin;
}

}  // namespace restenosis
