#include "tissue/biology/ContactInhibitionParameters.h"

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {

void ContactInhibitionParameters::describe(ParameterVisitor& p) {
  p.choice(law, contactInhibitionLawNames(),
           {.key = "law",
            .source = "assumed",
            .description = "what makes a cell crowded: too few free directions, too many neighbours (T6, "
                           "ISR3D), or pressure"});
  p.quantity(exposureThreshold,
             {.key = "exposureThreshold",
              .minimum = 0,
              .maximum = 1,
              .source = "assumed",
              .description = "a cell with no more than this share of free directions is inhibited"});
  p.quantity(exposureRange, {.key = "exposureRange",
                             .minimum = 1,
                             .maximum = 5,
                             .source = "assumed",
                             .description = "neighbours within this times R1 + R2 cover directions"});
  p.quantity(cellCover, {.key = "cellCover",
                         .minimum = 0.1,
                         .maximum = 5,
                         .source = "assumed",
                         .description = "a cell covers the cone of this times its radius"});
  p.quantity(laminaCover, {.key = "laminaCover",
                           .minimum = 0.1,
                           .maximum = 5,
                           .source = "assumed",
                           .description = "a lamina agent covers the cone of this times its radius"});
  p.integer(directions, {.key = "directions",
                         .minimum = 6,
                         .maximum = 1000,
                         .source = "assumed",
                         .description = "directions sampled around a cell"});
  p.quantity(changeTolerance, {.key = "changeTolerance",
                               .minimum = 0,
                               .maximum = 1,
                               .source = "assumed",
                               .description = "cells are evaluated again when an agent near them has moved "
                                              "or grown by more than this times its radius"});
  p.quantity(countRange, {.key = "countRange",
                          .minimum = 1,
                          .maximum = 5,
                          .source = "assumed",
                          .description = "neighbourCount: neighbours within this times R1 + R2 count"});
  p.quantity(countThreshold,
             {.key = "countThreshold",
              .minimum = 0,
              .source = "assumed",
              .description = "neighbourCount: a cell with a larger weighted count is inhibited"});
  p.quantity(smcWeight,
             {.key = "smcWeight", .minimum = 0, .source = "ISR3D", .description = "weight of an SMC"});
  p.quantity(ielWeight,
             {.key = "ielWeight", .minimum = 0, .source = "ISR3D", .description = "weight of an IEL agent"});
  p.quantity(
      eelWeight,
      {.key = "eelWeight", .minimum = 0, .source = "assumed", .description = "weight of an EEL agent"});
  p.quantity(
      strutWeight,
      {.key = "strutWeight", .minimum = 0, .source = "ISR3D", .description = "weight of a strut agent"});
  p.quantity(stressThreshold, {.key = "stressThreshold",
                               .unit = "kPa",
                               .minimum = 0,
                               .maximum = 1e6,
                               .source = "assumed",
                               .description = "stress: a cell under a larger pressure is inhibited"});
}

}  // namespace restenosis
