#pragma once

#include <optional>

#include "tissue/parameters/ParameterProblem.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Adds all that does not fit together in the vessel's parameters, for a stent that is pressed in by
/// `deploymentDepth` [m] (nothing: no stent): more agents than there is space for, a wall's table that cannot
/// be read or does not fit.
void checkVessel(const VesselParameters& vessel, std::optional<double> deploymentDepth,
                 ParameterProblems& problems);

}  // namespace restenosis
