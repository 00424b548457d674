#pragma once

#include <vector>

#include "bridge/compare/ComparedParts.h"
#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// The traction of a flow [Pa] on the triangles of the lumen it was solved in, whatever its own faces are:
/// the mean of the four nearest faces of the same region (wall or strut), weighted by the inverse square of
/// their distance. A flow whose faces are these triangles is returned as it is. NaN where the flow has no
/// face of that region.
std::vector<Vec3> carriedTraction(const TriSurface& lumen, const ComparedFaces& faces,
                                  const FlowSolution& flow);

}  // namespace restenosis
