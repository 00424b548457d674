#pragma once

#include <cstdint>

#include "AgentCounts.h"
#include "MechanicsParameters.h"
#include "Relaxation.h"
#include "VesselParameters.h"
#include "Wall.h"

namespace restenosis {

/// Places the agents of a wall at random, no two nearer than a share of the sum of their radii (a Poisson
/// disc): the IEL one cell radius outside the lumen, the EEL one inside the wall's outer face, cells between
/// the two. Not in equilibrium. Radii are normal about the mean, cut at three standard deviations.
Wall scatterWall(const VesselParameters& vessel, std::uint64_t seed);

/// What packing did.
struct PackingReport {
  AgentCounts counts;
  RelaxationReport packed;    ///< with the laminae held to their cylinders
  RelaxationReport released;  ///< then set free
  double ielDrift = 0;        ///< mean radial move of the IEL on release [m]
  Index expelled = 0;         ///< cells outside the space between the laminae afterwards
  std::size_t bonds = 0;
};

/// A wall in equilibrium: scattered, relaxed with the laminae sliding on their cylinders, released, relaxed
/// again, bonded with every bond at rest, ends fixed, ordered in space. The same for any number of threads.
/// Throws RelaxationFailed where it does not reach equilibrium.
Wall packWall(const VesselParameters& vessel, const MechanicsParameters& mechanics, std::uint64_t seed,
              PackingReport* report = nullptr);

/// A wall of loaded agents (AgentTable): bonded as it stands, ends fixed, ordered in space; not relaxed.
Wall adoptWall(const VesselParameters& vessel, AgentStore agents);

}  // namespace restenosis
