#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "ParameterProblem.h"
#include "StentParameters.h"
#include "VesselParameters.h"

namespace restenosis {

/// Whether a key, with its section, has a value that can be relied on.
using KeyIsKnown = std::function<bool(std::string_view key)>;

/// Everything about the vessel and the stent (null: none) that does not fit together: a stent longer than the
/// vessel, struts thicker than the lumen, a depth beyond the wall, rings that overlap, a wall's table that
/// cannot be read or does not fit the vessel. What `stent.file` holds is for its reader to say. Nothing is
/// said by what reads a key that is not known. Empty if all is well.
std::vector<ParameterProblem> validate(
    const VesselParameters& vessel, const StentParameters* stent,
    const KeyIsKnown& known = [](std::string_view) { return true; });

}  // namespace restenosis
