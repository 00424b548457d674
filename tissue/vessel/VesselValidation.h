#pragma once

#include <vector>

#include "ParameterProblem.h"
#include "StentParameters.h"
#include "VesselParameters.h"

namespace restenosis {

/// Everything about the vessel and the stent (null: none) that does not fit together: a stent longer than the
/// vessel, struts thicker than the lumen, a depth beyond the wall, rings that overlap, a wall's table that
/// cannot be read or does not fit the vessel. What `stent.file` holds is for its reader to say. Empty if all
/// is well.
std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent);

}  // namespace restenosis
