#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/PointGrid.h"
#include "tissue/vessel/SurfaceFromAxis.h"

namespace restenosis {

/// Adds agents at random places between two surfaces, one after another, none nearer to an earlier one than
/// a share of the sum of their radii. The share starts high and is lowered a little whenever an agent finds
/// no place, so it always ends. Every place is a function of (seed, agent id).
///
/// The agents of a batch seek places in parallel, each among the agents already placed. They are then placed
/// in order; one that an earlier agent of its batch blocks seeks on. The places are those of a serial run.
class PoissonScatter {
 public:
  /// Agents at 0 <= z <= length, no farther than outerRadius from the axis [m]; `smallest` and `largest`
  /// bound the radii.
  PoissonScatter(std::uint64_t seed, double length, double outerRadius, double smallest, double largest);

  /// Radius of the agent with this id [m]; called from several threads.
  using RadiusOf = std::function<double(AgentId)>;
  /// Appends `count` agents of `kind` with their centres between the two surfaces, or on the surface if both
  /// are the same, beginning at the full share.
  void add(AgentStore& agents, AgentKind kind, Index count, const RadiusOf& radiusOf,
           const SurfaceFromAxis& inner, const SurfaceFromAxis& outer);
  /// Callback before every batch; it may throw to cancel.
  void callMeanwhile(std::function<void()> meanwhile) { meanwhile_ = std::move(meanwhile); }

 private:
  // Random sequential addition of spheres jams at 0.38 of the volume (0.55 of the area for discs); 0.82 of
  // the diameter puts a wall of packing fraction 0.62 at 0.34. Both numbers are assumed and only set the
  // start of the relaxation.
  static constexpr double initialShare = 0.82;
  static constexpr int triesBeforeLowering = 200;
  // Speed only.
  static constexpr Index batchSize = 256;
  static constexpr std::ptrdiff_t seekersPerChunk = 16, parallelFromSeekers = 64;

  struct Region {
    const SurfaceFromAxis &inner, &outer;
  };
  /// An agent that seeks its place.
  struct Seeker {
    RandomStream stream;
    double radius;
    int tries = 0;
    Vec3 place = Vec3::Zero();       ///< the last that was tried
    std::array<Vec3, 8> ahead = {};  ///< next places, drawn together to overlap their memory accesses
    std::size_t next = 0, drawn = 0;
  };

  /// A random place of uniform density.
  Vec3 draw(RandomStream& stream, const Region& region) const;
  /// Tries the next place.
  void tryNext(Seeker& seeker, const Region& region) const;
  /// Tries places until one is free (true) or the share is to be lowered (false).
  bool seek(Seeker& seeker, const Region& region, const AgentStore& agents) const;
  /// Whether none of `others` blocks the place that a seeker found.
  bool isFreeOf(std::span<const Index> others, const Seeker& seeker, const AgentStore& agents) const;

  std::uint64_t seed_;
  double length_, smallest_, largest_;
  double share_ = initialShare;
  std::function<void()> meanwhile_;
  PointGrid grid_;
};

}  // namespace restenosis
