#pragma once

#include <string>
#include <vector>

#include "bridge/scene/Scene.h"
#include "tissue/biology/ArrestRules.h"

namespace restenosis {

/// What is known of a scene's flow before it is solved, as ends of a sentence that begins with the flow: that
/// it will be refused (resolutionProblem) or fail on this machine, or that it is no laminar one. Empty where
/// the scene's flow is never solved. `ranks`: processes of OpenFOAM.
std::vector<std::string> flowForecast(const Scene& scene, int ranks);

/// Of these, that it is no laminar one; empty where it is, or is never solved.
std::string turbulenceForecast(const Scene& scene);

/// Whether Poiseuille's law is the exact answer: in a straight tube without tissue, at a fixed flow rate. The
/// scene has a flow.
bool obeysPoiseuille(const Scene& scene);

/// Why the flow of a scene is never solved, or empty. `rules`: those by which its cells rest.
std::string noFlowBecause(const Scene& scene, const ArrestRules& rules);
std::string noFlowBecause(const Scene& scene);

}  // namespace restenosis
