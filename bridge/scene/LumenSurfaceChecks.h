#pragma once

#include <optional>

#include "bridge/scene/FlowResolution.h"
#include "bridge/scene/Scene.h"
#include "bridge/scene/SceneDocument.h"
#include "bridge/scene/SceneFindings.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// Reads the lumen that a scene loads, if any, and checks that flow can be solved in it by the scene's
/// backend, or that the scene's tissue can be built around it; adds what is wrong to `findings`. Where the
/// scene gives no `length` or `lumenDiameter`, they become the surface's: the distance between the centres of
/// its ends, and the diameter of the circle of its inlet's area. Does nothing while the file or its unit are
/// already found wrong. Returns the surface's extent if there is one to be used.
std::optional<LoadedExtent> takeLumenSurface(Scene& scene, const SceneDocument& document, const Units& units,
                                             SceneFindings& findings);

/// Reads the centreline that a scene gives, if any, and checks that its tissue can be built around its radii;
/// adds what is wrong to `findings`. The vessel's `length` becomes the axis's; where the scene gives no
/// `lumenDiameter`, that of the first point's radius.
void takeCentreline(Scene& scene, const SceneDocument& document, const Units& units, SceneFindings& findings);

}  // namespace restenosis
