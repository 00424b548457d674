#include "tissue/stent/InjuryParameters.h"

#include <algorithm>
#include <array>

#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::array synthetics{Named<bool>{"nearInjury", false}, Named<bool>{"all", true}};
constexpr std::array denudations{Named<bool>{"full", true}, Named<bool>{"none", false}};

}  // namespace

bool InjuryParameters::everyCellSynthetic() const {
  return findNamed(synthetics, "injury.synthetic", synthetic).value;
}

bool InjuryParameters::denuded() const {
  return findNamed(denudations, "injury.denudation", denudation).value;
}

bool InjuryParameters::sparesIel(bool stented) const {
  // Limits that a packed IEL exceeds already
  const bool anyStrain =
      stretchedStrain == 0 || (ielBreaks && std::min(strainLimitAround, strainLimitAlong) == 0);
  const bool anyStress = ielBreaks && stressLimit > 0;
  return !(removeIel || stented || anyStrain || anyStress);
}

void InjuryParameters::describe(ParameterVisitor& p) {
  p.boolean(ielBreaks, {.key = "ielBreaks",
                        .source = "T6",
                        .description = "whether bonds of the IEL break past "
                                       "the strain limits (injury 3 and 4)"});
  p.quantity(strainLimitAround, {.key = "strainLimitAround",
                                 .minimum = 0,
                                 .maximum = 100,
                                 .source = "ISR2D",
                                 .description = "strain at which an IEL bond around the vessel breaks"});
  p.quantity(strainLimitAlong, {.key = "strainLimitAlong",
                                .minimum = 0,
                                .maximum = 100,
                                .source = "ISR2D",
                                .description = "strain at which an IEL bond along the vessel breaks"});
  p.quantity(stressLimit, {.key = "stressLimit",
                           .unit = "MPa",
                           .minimum = 0,
                           .maximum = 1000,
                           .source = "assumed",
                           .description = "where ielBreaks is true, structural stress, in tension or "
                                          "compression, past which an IEL agent is no longer "
                                          "IEL; 0: no limit"});
  p.quantity(fenestrationProbability,
             {.key = "fenestrationProbability",
              .minimum = 0,
              .maximum = 1,
              .source = "ISR3D",
              .description = "probability that a stretched IEL agent becomes permeable"});
  p.quantity(stretchedStrain,
             {.key = "stretchedStrain",
              .minimum = 0,
              .maximum = 100,
              .source = "assumed",
              .description = "stretch of the IEL about an agent above which it counts as stretched"});
  p.quantity(endMargin,
             {.key = "endMargin",
              .unit = "mm",
              .minimum = 0,
              .maximum = 100,
              .source = "assumed",
              .description = "the IEL nearer a fixed end, or in the outer quarters of a vessel shorter "
                             "than four of this, is never injured"});
  p.quantity(syntheticReach, {.key = "syntheticReach",
                              .minimum = 0,
                              .maximum = 20,
                              .source = "assumed",
                              .description = "cells within this times R1 + R2 of an injured IEL agent become "
                                             "synthetic"});
  p.choice(synthetic, namesOf(synthetics),
           {.key = "synthetic", .source = "T6", .description = "which cells may cycle"});
  p.choice(denudation, namesOf(denudations),
           {.key = "denudation", .source = "T6", .description = "whether deployment strips the endothelium"});
  p.boolean(
      removeIel,
      {.key = "removeIel", .source = "assumed", .description = "remove the whole IEL before growth starts"});
}

}  // namespace restenosis
