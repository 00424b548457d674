#include "bridge/surface/LumenGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace restenosis {

LumenGrid::LumenGrid(double vesselLength, double halfWidth, double resolution) {
  if (!(vesselLength > 0 && halfWidth > 0 && resolution > 0) || !std::isfinite(vesselLength + halfWidth))
    throw std::invalid_argument("a lumen grid needs a positive length, width and resolution");
  length = vesselLength;
  spacing = resolution;
  nz = std::max(2, static_cast<int>(std::lround(length / resolution))) + 1;
  spacingZ = length / (nz - 1);
  nx = ny = 2 * std::max(1, static_cast<int>(std::ceil(halfWidth / resolution))) + 1;
}

}  // namespace restenosis
