#include "tissue/biology/ActivationParameters.h"

namespace restenosis {

void ActivationParameters::describe(ParameterVisitor& p) {
  p.quantity(entryRate,
             {.key = "entryRate",
              .unit = "1/d",
              .minimum = 0,
              .maximum = 10000,
              .source = "assumed",
              .description = "rate at which a fully activated cell that nothing holds leaves rest"});
  p.quantity(decayTime, {.key = "decayTime",
                         .unit = "d",
                         .minimum = 0,
                         .maximum = 1e6,
                         .minimumAllowed = false,
                         .source = "assumed",
                         .description = "time in which activation falls to 1/e"});
  p.quantity(stretchOnset, {.key = "stretchOnset",
                            .minimum = 0,
                            .maximum = 100,
                            .source = "assumed",
                            .description = "strain of the tissue around the vessel, from the packed to the "
                                           "deployed wall, from which on it activates cells"});
  p.quantity(stretchFull, {.key = "stretchFull",
                           .minimum = 0,
                           .maximum = 100,
                           .source = "assumed",
                           .description = "strain from which on it activates them fully; from stretchOnset "
                                          "on activation rises evenly"});
}

}  // namespace restenosis
