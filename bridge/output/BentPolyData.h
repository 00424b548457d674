#pragma once

#include <vtkPolyData.h>

#include "bridge/surface/Centreline.h"

namespace restenosis {

/// Bends what is drawn about the z axis along an axis: points move, the cells' array `traction`, where there
/// is one, turns with them, and the points get the array `straightPosition`, where they were [m].
void bendPolyData(vtkPolyData& data, const Centreline& axis);

}  // namespace restenosis
