#pragma once

#include <stdexcept>
#include <string>

#include "tissue/stent/DeploymentStatistics.h"

namespace restenosis {

/// Struts that have gone through the wall instead of pressing it outwards. what() names the setting.
struct DeploymentFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether struts have clearly gone through the wall: of the free agents in their way more than a tenth,
/// about one layer of cells, are left behind lumenward of their outer faces, by more than half a cell radius
/// (assumed), so far as no soft contact lets a strut sink in.
bool strutsWentThrough(const DeploymentStatistics& wall);

/// What is to be said of agents lumenward of struts' outer faces after a deployment in so many steps, and
/// which settings keep them where they belong: `stent.deploymentSteps` free ones that struts have passed,
/// `vessel.fixedEnds` those that are fixed. Where none is passed the struts have sunk in as deep as soft
/// contacts allow. Empty where there are none.
std::string remarkOnEscaped(const DeploymentStatistics& wall, int deploymentSteps);

/// Throws DeploymentFailed where strutsWentThrough.
void requireWallOutsideStruts(const DeploymentStatistics& wall, int deploymentSteps);

}  // namespace restenosis
