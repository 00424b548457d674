#pragma once

#include "bridge/scene/Scene.h"
#include "tissue/biology/BiologySettings.h"

namespace restenosis {

/// The settings of a scene's biology.
BiologySettings biologySettings(const Scene& scene);

/// Whether the flow of a scene is solved for its tissue: whether it has one, and a rule that reads it.
bool growthReadsFlow(const Scene& scene);

}  // namespace restenosis
