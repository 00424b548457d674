#pragma once

#include <cstdint>
#include <functional>

#include "tissue/equilibrium/Relaxation.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/vessel/AgentCounts.h"
#include "tissue/vessel/VesselParameters.h"
#include "tissue/vessel/Wall.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// Places the agents of a wall of this shape at random, no two nearer than a share of the sum of their radii
/// (Poisson disc). Not in equilibrium. Radii are normal about the mean, cut at three standard deviations.
/// `meanwhile` is called repeatedly and may throw to cancel.
Wall scatterWall(const VesselParameters& vessel, const WallShape& shape, std::uint64_t seed,
                 const std::function<void()>& meanwhile = {});

/// What packing did.
struct PackingReport {
  AgentCounts counts;
  RelaxationReport packed;    ///< with the laminae held to their surfaces
  RelaxationReport released;  ///< after their release
  double ielDrift = 0;        ///< mean radial move of the IEL on release [m]
  double rmsMove = 0;         ///< root mean square displacement on release [m]
  Index expelled = 0;         ///< cells outside the space between the laminae afterwards
  std::size_t bonds = 0;

  template <class Archive>
  void archive(Archive& a) {
    a(counts.iel, counts.eel, counts.smc, packed, released, ielDrift, rmsMove, expelled, bonds);
  }
};

/// A wall in equilibrium: scattered, relaxed with the laminae sliding on their surfaces, bonded with every
/// bond at rest, released, relaxed again, ends fixed, ordered in space. The small load that the bonds then
/// carry is the packing's pressure on the laminae. The same for any number of threads. Throws
/// RelaxationFailed where it does not reach equilibrium. `meanwhile` is called repeatedly and may throw to
/// cancel.
Wall packWall(const VesselParameters& vessel, const WallShape& shape, const MechanicsParameters& mechanics,
              const RelaxationParameters& relaxation, std::uint64_t seed, PackingReport* report = nullptr,
              const std::function<void()>& meanwhile = {});
/// The same around a cylinder.
Wall packWall(const VesselParameters& vessel, const MechanicsParameters& mechanics,
              const RelaxationParameters& relaxation, std::uint64_t seed, PackingReport* report = nullptr);

/// A wall of loaded agents (AgentTable): bonded as it stands, ends fixed, ordered in space; not relaxed.
Wall adoptWall(const VesselParameters& vessel, AgentStore agents);

}  // namespace restenosis
