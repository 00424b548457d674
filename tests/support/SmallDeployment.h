#pragma once

#include "tissue/equilibrium/RelaxationParameters.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis::support {

/// One ring in a narrow, short vessel, at a looser tolerance: quick, and all of what a deployment does.
struct SmallDeployment {
  SmallDeployment() {
    vessel.length = 0.3e-3;
    vessel.lumenDiameter = 0.4e-3;
    stent.deploymentDepth = 60e-6;
    stent.deploymentSteps = 20;
    relaxation.tolerance = 0.003;
  }
  VesselParameters vessel;
  StentParameters stent;
  MechanicsParameters mechanics;
  RelaxationParameters relaxation;
};

}  // namespace restenosis::support
