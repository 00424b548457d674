#pragma once

#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Strain of the tissue around the vessel at each agent, from its packed to its present place: |F e| - 1 with
/// the unit vector e around the axis at the packed place. F is the deformation gradient that fits the
/// agent's neighbours in the packed wall in the least-squares sense, those within twice the sum of the radii;
/// it is exact where the deformation is affine. 0 for an agent with neighbours that do not determine it and
/// for agents beyond `packedPlaces`, which are struts. `packedPlaces`: x, y, z by agent [m].
std::vector<double> strainAroundVessel(const AgentStore& agents, std::span<const double> packedPlaces);

}  // namespace restenosis
