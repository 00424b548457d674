#include "EndotheliumParameters.h"

namespace restenosis {

void EndotheliumParameters::describe(ParameterVisitor& p) {
  p.choice(scenario, {"3-23 days", "slow linear", "fast", "normal", "slow", "none"},
           {.key = "scenario",
            .source = "T6",
            .description = "how the endothelium returns: coverage against time"});
  p.quantity(nitricOxideThreshold, {.key = "nitricOxideThreshold",
                                    .unit = "nmol/mm^3",
                                    .minimum = 0,
                                    .maximum = 1e6,
                                    .source = "ISR3D",
                                    .description = "nitric oxide that sends a cell to rest"});
}

}  // namespace restenosis
