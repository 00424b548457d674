#pragma once

#include <string>
#include <vector>

#include "bridge/surface/LumenCap.h"
#include "bridge/surface/StlFile.h"

namespace restenosis {

/// The parts of a loaded lumen, inlet, outlet, wall and strut, one a line, each with its area, its place and
/// the solids or rims that it came from, and by what the inlet was told. `file` has the surface with its
/// regions; `ends`: the inlet, then the outlets.
std::vector<std::string> lumenParts(const SurfaceSolids& file, const std::vector<LumenCap>& ends);

/// That solids are named as struts which the shape does not show to be any: they are more than half of the
/// side, or lie flush in the wall (both assumed). Empty where there is nothing to say.
std::string remarkOnStruts(const SurfaceSolids& file);

/// That there are flat faces like ends beside two that are named so, as of a third branch, which become wall.
/// Empty where there is nothing to say.
std::string remarkOnOtherFaces(const SurfaceSolids& file, const std::vector<LumenCap>& ends);

/// The axis, 0 to 2, along which the ends' centres differ most: it tells the inlet where no name does.
Eigen::Index axisBetween(const TriSurface& surface, const std::vector<LumenCap>& ends);

}  // namespace restenosis
