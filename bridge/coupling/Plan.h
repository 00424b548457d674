#pragma once

#include <string>
#include <vector>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// What the plan says of one part of a run.
struct PlannedPart {
  std::string name;
  bool runs;
  std::string explanation;  ///< when it runs, or why it does not
};

/// Which parts of a scene would run and when, which would not and why; from the scene alone, by the same
/// rules the schedule follows.
std::vector<PlannedPart> planParts(const Scene& scene);

/// What the files of a scene that hold surfaces are taken to be: of a lumen inlet, outlet, wall and strut
/// with their area, place and origin, of a stent its struts. Empty where there are none. Throws as makeStent
/// does.
std::string surfacesText(const Scene& scene);

/// The plan as text: what is modelled, the parts, agents (struts included; of a loaded wall those of its
/// table), estimated memory and time. Throws as makeStent does.
std::string planText(const Scene& scene);

}  // namespace restenosis
