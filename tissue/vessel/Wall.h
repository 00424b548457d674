#pragma once

#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// The vessel's wall: its agents, the bonds between them and the cylinder they were made for. Strut agents
/// are appended to the same store by Deployment.
struct Wall {
  AgentStore agents;
  BondTable bonds;
  double length = 0;         ///< of the vessel, along z from 0 [m]
  double lumenRadius = 0;    ///< before stenting [m]
  double wallThickness = 0;  ///< [m]
  double cellRadius = 0;     ///< mean radius of the wall's agents [m]
  /// Displacement of each agent in the last deployment step: x, y, z by agent [m]; empty before the first
  /// step and once deployment is over.
  std::vector<double> lastMove;
  /// Where each agent was before deployment: x, y, z by agent [m]. Empty once injury is over, and where
  /// nothing reads it.
  std::vector<double> packedPlaces;

  template <class Archive>
  void archive(Archive& a) {
    a(agents, bonds, length, lumenRadius, wallThickness, cellRadius, lastMove, packedPlaces);
  }
};

/// A wall without agents with the vessel's geometry.
inline Wall emptyWall(const VesselParameters& vessel) {
  Wall wall;
  wall.length = vessel.length;
  wall.lumenRadius = vessel.lumenDiameter / 2;
  wall.wallThickness = vessel.wallThickness;
  wall.cellRadius = vessel.cellRadius;
  return wall;
}

/// Flags agents with centres within `radii` mean cell radii of an end as fixed, all others as free.
void fixEnds(Wall& wall, double radii);

/// Flags every EEL agent as fixed (model 2: the tissue outside is stiff); the ends keep their flags.
void fixOuterLamina(Wall& wall);

/// Orders agents, bonds included, so that neighbours in space are neighbours in memory (spatialOrder). Ids
/// stay. Returns the former index of the agent at each place.
std::vector<Index> orderInSpace(Wall& wall);

}  // namespace restenosis
