#pragma once

#include <string>
#include <vector>

#include "StentParameters.h"
#include "VesselParameters.h"

namespace restenosis {

/// A value that is within its own bounds but does not fit the others.
struct ParameterProblem {
  std::string key;      ///< with its section, as in "stent.length"
  std::string message;  ///< what is wrong and what is allowed
};

/// Everything about the vessel and the stent (null: none) that does not fit together: a stent longer than the
/// vessel, struts thicker than the lumen, a depth beyond the wall, rings that overlap, tables that cannot be
/// read or do not fit the vessel. Empty if all is well.
std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent);

}  // namespace restenosis
