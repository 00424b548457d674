#pragma once

#include <string>
#include <vector>

#include "bridge/output/PlannedPart.h"
#include "bridge/scene/Scene.h"

namespace restenosis {

/// What the files of a scene that hold surfaces are taken to be: of a lumen inlet, outlet, wall and strut
/// with their area, place and origin, of a stent its struts. Empty where there are none. Throws as makeStent
/// does.
std::string surfacesText(const Scene& scene);

/// What each part of a run says of itself for the scene. Throws as makeStent does.
std::vector<PlannedPart> plannedParts(const Scene& scene);

/// What `check` says of a scene: what is modelled, which parts of a run run when and which do not and why
/// (each part explains itself), agents (struts included; of a loaded wall those of its
/// table), estimated memory and time, with that of the flow, and how far the fidelity's
/// neointima is off. Throws as makeStent does.
std::string planText(const Scene& scene);
/// The same as JSON, for programs: units are in the names.
std::string planJson(const Scene& scene);

}  // namespace restenosis
