#pragma once

#include <filesystem>

#include "bridge/flow/FlowBackend.h"
#include "bridge/surface/Centreline.h"
#include "bridge/surface/RadialMap.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Writes the lumen's wall and struts (the open tube: the ends would hide its inside) [m] with the arrays
/// region (0 wall, 1 strut), WSS (magnitude) and traction (vector) [Pa] on its triangles, and lumenRadius
/// (distance from the vessel's axis) [m] on its points; where the lumen just after deployment is given,
/// neointimaThickness (its radius there minus the present one) [m], too. The field data inletCentre and
/// outletCentre [m] say where the ends are that it has.
///
/// A triangle carries the traction of the flow's nearest face of its region (of the other one where the flow
/// has none), whatever the flow's own faces are; NaN, that is "not known", when `flow` is null or has no
/// faces. Of a flow that beats there are the arrays TAWSS, OSI, RRT and transWSS, too. All is bent along an
/// axis that is given (bendPolyData). `time` is in s. Throws WriteFailed.
void writeLumen(const std::filesystem::path& file, const TriSurface& lumen, const FlowSolution* flow,
                double time, const RadialMap* postDeployment = nullptr, const Centreline* axis = nullptr);

}  // namespace restenosis
