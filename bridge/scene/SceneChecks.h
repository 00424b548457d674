#pragma once

#include <optional>

#include "bridge/scene/FlowResolution.h"
#include "bridge/scene/Scene.h"
#include "bridge/scene/SceneDocument.h"
#include "bridge/scene/SceneFindings.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// Checks what no single key can tell: sections that need each other, lengths that must fit into each other.
/// Adds what is wrong to `findings`, at the key to blame. Skips checks of keys that are already found wrong.
/// `loaded`: of the lumen that the scene loads, if any (`takeLumenSurface`).
void checkScene(const Scene& scene, const SceneDocument& document, const Units& units,
                const std::optional<LoadedExtent>& loaded, SceneFindings& findings);

/// Agents of the packed wall, from the packing fraction and the mean radius: what memory and time go with.
/// Zero for a scene without tissue, or with agents from a file.
double estimatedAgents(const Scene& scene);

}  // namespace restenosis
