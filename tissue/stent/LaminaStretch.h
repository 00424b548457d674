#pragma once

#include <vector>

#include "tissue/vessel/Wall.h"

namespace restenosis {

/// Stretch of the IEL, a sheet of bonded agents, about each of its agents: the largest principal strain of
/// the deformation fitted to the bonds of the agent and of its bonded partners with other IEL agents; 0 for
/// all other agents and for agents without such a bond.
///
/// A single bond of an irregular sheet says little: its strain depends on how its two agents happened to
/// slip. The strain tensor e (Almansi, in the plane of the bonds as they are now) is therefore the
/// least-squares solution of 1 - (L / D)^2 = 2 n.e.n over the bonds with direction n, length D and rest
/// length L, which needs no reference positions and is exact where the sheet is deformed evenly. The strain
/// returned is 1 / sqrt(1 - 2 e_max) - 1, the relative elongation along the principal direction.
std::vector<double> laminaStretch(const Wall& wall);

}  // namespace restenosis
