#pragma once

#include "PointGrid.h"
#include "RandomStream.h"

namespace restenosis {

/// Adds agents at random places between two cylinders, one after another, none nearer to an earlier one than
/// a share of the sum of their radii. The share starts high and is lowered a little whenever an agent finds
/// no place, so it always ends. Every place is a function of (seed, agent id).
class PoissonScatter {
 public:
  /// Agents between `low` and `high` radius and 0 <= z <= length [m]; `largest` bounds the radii.
  PoissonScatter(std::uint64_t seed, double length, double outerRadius, double largest);

  /// Appends an agent of `kind` and `radius` with its centre between the cylinders `innerLimit` and
  /// `outerLimit` (which may be equal: on a cylinder).
  void add(AgentStore& agents, AgentKind kind, double radius, double innerLimit, double outerLimit);
  /// Starts the next group of agents at the full share again.
  void restart() { share_ = initialShare; }

 private:
  // Random sequential addition of spheres jams at 0.38 of the volume (0.55 of the area for discs); 0.82 of
  // the diameter puts a wall of packing fraction 0.62 at 0.34. Both numbers are assumed and only set the
  // start of the relaxation.
  static constexpr double initialShare = 0.82;
  static constexpr int triesBeforeLowering = 200;

  std::uint64_t seed_;
  double length_, largest_;
  double share_ = initialShare;
  PointGrid grid_;
};

}  // namespace restenosis
