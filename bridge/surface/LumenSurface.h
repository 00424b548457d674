#pragma once

#include <stdexcept>

#include "bridge/surface/LumenField.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Thrown when a surface is asked of a lumen that does not join inlet and outlet.
struct Occluded : std::runtime_error {
  Occluded() : std::runtime_error("the lumen is occluded: nothing open joins inlet and outlet") {}
};

/// The closed surface of a lumen: the isosurface 0 of the field (Isosurface.h). Regions: wall or strut by the
/// nearer of the two, inlet and outlet for the caps. Throws Occluded.
TriSurface extractSurface(const LumenField& field);

}  // namespace restenosis
