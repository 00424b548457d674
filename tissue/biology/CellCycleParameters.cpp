#include "tissue/biology/CellCycleParameters.h"

namespace restenosis {

void CellCycleParameters::describe(ParameterVisitor& p) {
  p.quantity(g1Mean, {.key = "g1Mean",
                      .unit = "h",
                      .minimum = 0,
                      .maximum = 10000,
                      .source = "ISR3D",
                      .description = "mean duration of G1"});
  p.quantity(g1Spread, {.key = "g1Spread",
                        .unit = "h",
                        .minimum = 0,
                        .maximum = 10000,
                        .source = "ISR3D",
                        .description = "standard deviation of the duration of G1, truncated at three"});
  p.quantity(sg2mDuration, {.key = "sg2mDuration",
                            .unit = "h",
                            .minimum = 0,
                            .maximum = 10000,
                            .source = "ISR3D",
                            .description = "duration of S, G2 and M together"});
  p.quantity(recruitment, {.key = "recruitment",
                           .unit = "h",
                           .minimum = 0,
                           .maximum = 10000,
                           .source = "assumed",
                           .description = "time over which cells that never divided may first leave rest, "
                                          "each at a random moment; 0: all at once"});
  p.quantity(daughterDisplacement, {.key = "daughterDisplacement",
                                    .minimum = 0.01,
                                    .maximum = 1,
                                    .source = "ISR3D",
                                    .description = "displacement of mother and daughter from "
                                                   "the mother's centre over its radius"});
}

}  // namespace restenosis
