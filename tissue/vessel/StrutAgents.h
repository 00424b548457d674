#pragma once

#include "Stent.h"
#include "StentParameters.h"
#include "VesselParameters.h"

namespace restenosis {

/// Obstacle spheres that cover the segments: centres on the section's boundary, set in by a radius so that
/// the outermost spheres are flush with the faces, about one radius apart, so that no cell slips between
/// them; open ends of chains are filled. Radius: `cellRadius`, or half the section where that is thinner.
std::vector<StrutSphere> coverWithSpheres(const std::vector<StrutSegment>& segments, double cellRadius);

/// The stent of a scene before deployment, its outer face at the lumen's surface: a design, or the spheres of
/// a table, each a strut segment of its own, moved along their radii so that the outermost touches the lumen.
/// Throws AgentTableError for a table that does not fit, std::invalid_argument for an unknown design.
Stent makeStent(const StentParameters& stent, const VesselParameters& vessel);

}  // namespace restenosis
