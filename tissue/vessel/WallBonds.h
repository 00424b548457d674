#pragma once

#include "tissue/vessel/Wall.h"

namespace restenosis {

/// Bonds wall agents (not struts) with centres nearer than `range` times the sum of their radii, the
/// nearest pairs first, at most BondTable::maxBonds per agent. The rest length is the present distance, so
/// the bonds carry no force now. Earlier bonds are dropped. Returns the number of bonds.
std::size_t bondWall(Wall& wall, double range);

}  // namespace restenosis
