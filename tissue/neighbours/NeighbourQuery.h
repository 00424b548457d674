#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tissue/neighbours/CellGrid.h"

namespace restenosis {

/// Finds the agents near an agent. Holds scratch memory: one query object a thread, any number over one grid.
/// The agents must not have moved since the grid was made.
class NeighbourQuery {
 public:
  NeighbourQuery(const AgentStore& agents, const CellGrid& grid)
      : NeighbourQuery(agents, grid, largestRadius(agents)) {}
  /// The same where the largest radius is known [m].
  NeighbourQuery(const AgentStore& agents, const CellGrid& grid, double largestRadius)
      : agents_(agents), grid_(grid), largestRadius_(largestRadius) {}

  /// Calls f(j, distance) for every other agent j with its centre within factor (R_i + R_j) of that of agent
  /// i, in ascending order of j.
  template <class F>
  void forEachNeighbour(Index i, double factor, F&& f) {
    found_.clear();
    const Vec3 centre = agents_.position(i);
    const double reach = factor * (agents_.radius[i] + largestRadius_);
    grid_.forEachCandidate(centre, reach, [&](Index j) {
      if (j == i) return;
      const double range = factor * (agents_.radius[i] + agents_.radius[j]);
      const double squared = (agents_.position(j) - centre).squaredNorm();
      if (squared <= range * range) found_.push_back({j, std::sqrt(squared)});
    });
    std::ranges::sort(found_, {}, &Found::agent);
    for (const Found& found : found_) f(found.agent, found.distance);
  }

  static double largestRadius(const AgentStore& agents) {
    return agents.size() == 0 ? 0 : *std::ranges::max_element(agents.radius);
  }

 private:
  struct Found {
    Index agent;
    double distance;
  };
  const AgentStore& agents_;
  const CellGrid& grid_;
  double largestRadius_;
  std::vector<Found> found_;
};

}  // namespace restenosis
