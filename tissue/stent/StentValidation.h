#pragma once

#include <string_view>
#include <vector>

#include "tissue/parameters/ParameterProblem.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Everything about the vessel and the stent (null: none) that does not fit together: a stent longer than the
/// vessel, struts thicker than the lumen, a depth beyond the wall, rings that overlap, and what checkVessel
/// finds. The reader of `stent.file` checks its contents. A check that reads a key that is not known finds
/// nothing. Empty if all is well.
std::vector<ParameterProblem> validate(
    const VesselParameters& vessel, const StentParameters* stent,
    const KeyIsKnown& known = [](std::string_view) { return true; });

}  // namespace restenosis
