#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/MovableGrid.h"
#include "tissue/vessel/SurfaceFromAxis.h"

namespace restenosis {

/// Adds agents at random places between two surfaces, one after another, none nearer to an earlier one than
/// a share of the sum of their radii. The share starts high and is lowered a little whenever an agent finds
/// no place, so it always ends. Every place is a function of (seed, agent id).
class PoissonScatter {
 public:
  /// About `count` agents at 0 <= z <= length, no farther than outerRadius from the axis [m]; `largest`
  /// bounds their radii.
  PoissonScatter(std::uint64_t seed, double length, double outerRadius, std::size_t count, double largest);

  /// The radius of the agent with this id [m].
  using RadiusOf = std::function<double(AgentId)>;
  /// Appends `count` agents of `kind` with their centres between the two surfaces, or on the surface that
  /// both are, beginning at the full share.
  void add(AgentStore& agents, AgentKind kind, Index count, const RadiusOf& radiusOf,
           const SurfaceFromAxis& inner, const SurfaceFromAxis& outer);
  /// Called now and then; it may throw to give up.
  void setCallback(std::function<void()> callback) { callback_ = std::move(callback); }

 private:
  // Random sequential addition of spheres jams at 0.38 of the volume (0.55 of the area for discs); 0.82 of
  // the diameter puts a wall of packing fraction 0.62 at 0.34. Both numbers are assumed and only set the
  // start of the relaxation.
  static constexpr double initialShare = 0.82;
  static constexpr int triesBeforeLowering = 200;
  static constexpr Index agentsBetweenCallbacks = 256;

  struct Region {
    const SurfaceFromAxis &inner, &outer;
  };
  /// A random place of uniform density.
  Vec3 draw(RandomStream& stream, const Region& region) const;
  /// Whether no earlier agent is too near.
  bool isFree(const AgentStore& agents, const Vec3& place, double radius) const;

  std::uint64_t seed_;
  double length_, largest_;
  double share_ = initialShare;
  std::function<void()> callback_;
  MovableGrid grid_;
};

}  // namespace restenosis
