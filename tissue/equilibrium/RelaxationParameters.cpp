#include "tissue/equilibrium/RelaxationParameters.h"

#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {

void RelaxationParameters::describe(ParameterVisitor& p) {
  p.choice(minimiser, minimiserNames(),
           {.key = "minimiser",
            .source = "assumed",
            .description = "method of reaching equilibrium: FIRE, or T6's overdamped motion"});
  p.choice(precision, {"automatic", "mixed", "double"},
           {.key = "precision",
            .source = "assumed",
            .description = "of forces; automatic: mixed from a tolerance of 5e-5 on"});
  p.quantity(tolerance,
             {.key = "tolerance",
              .minimum = 1e-9,
              .maximum = 0.1,
              .source = "assumed",
              .description = "how far the force left on an agent may still move it (the force over "
                             "the agent's stiffness), over its radius"});
  p.boolean(activeSet, {.key = "activeSet",
                        .source = "assumed",
                        .description = "move only agents that a disturbance reaches; without, all or none"});
  p.quantity(stepLimit, {.key = "stepLimit",
                         .minimum = 1e-6,
                         .maximum = 0.5,
                         .source = "model 3",
                         .description = "largest move of an agent in one relaxation step over its radius"});
  p.integer(maximumIterations, {.key = "maximumIterations",
                                .minimum = 1,
                                .maximum = 10000000,
                                .source = "assumed",
                                .description = "iterations after which a relaxation has failed"});
  p.boolean(stopAtMaximum, {.key = "stopAtMaximum",
                            .source = "T6",
                            .description = "go on with what maximumIterations gave (a fixed effort a step)"});
  p.quantity(axialForceFactor,
             {.key = "axialForceFactor",
              .minimum = 0.1,
              .maximum = 10,
              .source = "T6",
              .description = "factor on the axial part of every force: a mobility, no stiffness"});
}

}  // namespace restenosis
