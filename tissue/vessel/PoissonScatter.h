#pragma once

#include "PointGrid.h"
#include "RandomStream.h"
#include "SurfaceFromAxis.h"

namespace restenosis {

/// Adds agents at random places between two surfaces, one after another, none nearer to an earlier one than
/// a share of the sum of their radii. The share starts high and is lowered a little whenever an agent finds
/// no place, so it always ends. Every place is a function of (seed, agent id).
class PoissonScatter {
 public:
  /// Agents at 0 <= z <= length, no farther than outerRadius from the axis [m]; `smallest` and `largest`
  /// bound the radii.
  PoissonScatter(std::uint64_t seed, double length, double outerRadius, double smallest, double largest);

  /// Appends an agent of `kind` and `radius` with its centre between the two surfaces, or on the surface that
  /// both are.
  void add(AgentStore& agents, AgentKind kind, double radius, const SurfaceFromAxis& inner,
           const SurfaceFromAxis& outer);
  /// Starts the next group of agents at the full share again.
  void restart() { share_ = initialShare; }

 private:
  // Random sequential addition of spheres jams at 0.38 of the volume (0.55 of the area for discs); 0.82 of
  // the diameter puts a wall of packing fraction 0.62 at 0.34. Both numbers are assumed and only set the
  // start of the relaxation.
  static constexpr double initialShare = 0.82;
  static constexpr int triesBeforeLowering = 200;

  /// A random place of uniform density.
  Vec3 draw(RandomStream& stream, const SurfaceFromAxis& inner, const SurfaceFromAxis& outer) const;

  std::uint64_t seed_;
  double length_, smallest_, largest_;
  double share_ = initialShare;
  PointGrid grid_;
};

}  // namespace restenosis
