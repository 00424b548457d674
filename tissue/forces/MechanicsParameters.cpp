#include "tissue/forces/MechanicsParameters.h"

#include "tissue/forces/ContactLaws.h"

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
}

}  // namespace restenosis
