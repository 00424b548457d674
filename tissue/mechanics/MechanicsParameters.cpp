#include "MechanicsParameters.h"

#include "ContactLaws.h"
#include "Minimiser.h"

namespace restenosis {

void MechanicsParameters::describe(ParameterVisitor& p) {
  p.choice(contactLaw, contactLawNames(),
           {.key = "contactLaw", .source = "T6", .description = "repulsion of overlapping agents"});
  p.quantity(contactModulus, {.key = "contactModulus",
                              .unit = "MPa",
                              .minimum = 0,
                              .maximum = 1000,
                              .minimumAllowed = false,
                              .source = "ISR3D",
                              .description = "C of the neo-Hookean law; the Hertz law has E* = 6 C"});
  p.quantity(bondModulus, {.key = "bondModulus",
                           .unit = "MPa",
                           .minimum = 0,
                           .maximum = 1000,
                           .source = "ISR3D",
                           .description = "k of F = k strain (R1 + R2)^2 on bonds in tension"});
  p.quantity(bondAxialFactor, {.key = "bondAxialFactor",
                               .minimum = 0.01,
                               .maximum = 100,
                               .source = "assumed",
                               .description = "stiffness of bonds along the axis over that of bonds around"});
  p.quantity(bondStrainLimit,
             {.key = "bondStrainLimit",
              .minimum = 0,
              .maximum = 100,
              .source = "assumed",
              .description = "strain past which a bond breaks, but for those within the IEL, which "
                             "[injury] breaks; 0: no limit"});
  p.boolean(
      bondDaughters,
      {.key = "bondDaughters",
       .source = "assumed",
       .description = "bond daughters, once they have come to rest, to agents within vessel.bondRange"});
  p.quantity(cohesionModulus, {.key = "cohesionModulus",
                               .unit = "MPa",
                               .minimum = 0,
                               .maximum = 1000,
                               .source = "assumed",
                               .description = "weak attraction that keeps daughters attached"});
  p.quantity(cohesionRange, {.key = "cohesionRange",
                             .minimum = 1,
                             .maximum = 2,
                             .source = "assumed",
                             .description = "distance, over R1 + R2, at which cohesion ends"});
  p.quantity(axialForceFactor,
             {.key = "axialForceFactor",
              .minimum = 0.1,
              .maximum = 10,
              .source = "T6",
              .description = "factor on the axial part of every force: a mobility, no stiffness"});
  p.choice(minimiser, minimiserNames(),
           {.key = "minimiser",
            .source = "assumed",
            .description = "way to the equilibrium: FIRE, or T6's overdamped motion"});
  p.choice(
      precision, {"automatic", "mixed", "double"},
      {.key = "precision",
       .source = "assumed",
       .description = "of forces on the way to equilibrium; automatic: mixed from a tolerance of 0.01 on"});
  p.quantity(tolerance, {.key = "tolerance",
                         .minimum = 1e-8,
                         .maximum = 10,
                         .source = "ISR3D",
                         .description = "largest force left on an agent over C r0^2"});
  p.quantity(
      firmStiffness,
      {.key = "firmStiffness",
       .minimum = 0,
       .maximum = 100,
       .source = "assumed",
       .description = "of contacts over C r0; daughters held less firmly rest at less force in proportion"});
  p.boolean(sleeping, {.key = "sleeping",
                       .source = "assumed",
                       .description = "move only whom a disturbance reaches; without, all or none"});
  p.integer(yieldIterations,
            {.key = "yieldIterations",
             .minimum = 0,
             .maximum = 10000,
             .source = "assumed",
             .description = "iterations in which daughters around a disturbance move before those within "
                            "their tolerance sleep; 0: they sleep at once"});
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
}

}  // namespace restenosis
