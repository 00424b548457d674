#pragma once

#include <stdexcept>
#include <string>

#include "tissue/stent/DeploymentStatistics.h"

namespace restenosis {

/// Struts that have gone through the wall instead of pressing it outwards. what() names the setting.
struct DeploymentFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether struts have clearly gone through the wall: more than a tenth of the free agents in their path,
/// about one layer of cells, are lumenward of their outer faces by more than half a cell radius (assumed),
/// farther than soft contacts let a strut sink in.
bool strutsWentThrough(const DeploymentStatistics& wall);

/// Remark on agents lumenward of struts' outer faces after a deployment in so many steps, with the setting
/// that helps: `stent.deploymentSteps` for free agents that struts have passed, `vessel.fixedEnds` for fixed
/// ones. Where none is passed, the struts have sunk in as deep as soft contacts allow. Empty where no agent
/// is lumenward.
std::string remarkOnEscaped(const DeploymentStatistics& wall, int deploymentSteps);

/// Throws DeploymentFailed where strutsWentThrough.
void requireWallOutsideStruts(const DeploymentStatistics& wall, int deploymentSteps);

}  // namespace restenosis
