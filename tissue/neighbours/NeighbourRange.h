#pragma once

#include <algorithm>

namespace restenosis {

/// The pairs that may interact: centres closer than factor (R_i + R_j) + skin.
struct NeighbourRange {
  double factor = 1;          ///< of pairs in general
  double daughterFactor = 1;  ///< of pairs with at least one daughter, which cohere across a gap
  double skin = 0;            ///< [m]; how far two agents together may move before the list misses a pair

  double largestFactor() const { return std::max(factor, daughterFactor); }
  /// Distance beyond which no two agents are in range, no radius being above the largest one; 1 m where it
  /// would be 0 [m].
  double widestReach(double largestRadius) const {
    const double widest = 2 * largestFactor() * largestRadius + skin;
    return widest > 0 ? widest : 1.0;
  }
  bool operator==(const NeighbourRange&) const = default;
};

}  // namespace restenosis
