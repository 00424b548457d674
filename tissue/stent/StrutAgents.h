#pragma once

#include "tissue/stent/Stent.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/AgentTable.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Obstacle spheres that cover the segments: centres on the section's boundary, set in by a radius so that
/// the outermost spheres are flush with the faces, about one radius apart, so that no cell slips between
/// them; open ends of chains are filled. Radius: `cellRadius`, or half the section where that is thinner.
std::vector<StrutSphere> coverWithSpheres(const std::vector<StrutSegment>& segments, double cellRadius);

/// The stent of a design before deployment, its outer face at the lumen's surface. Throws
/// std::invalid_argument for an unknown design.
Stent stentOfDesign(const StentParameters& stent, const VesselParameters& vessel);

/// The stent of spheres from a file before deployment: each a strut segment of its own, moved along their
/// radii so that the outermost touches the lumen. Throws TableError for spheres that do not fit the
/// vessel (`outwardsToLumen`).
Stent stentOfSpheres(const AgentTable& struts, const VesselParameters& vessel);

}  // namespace restenosis
