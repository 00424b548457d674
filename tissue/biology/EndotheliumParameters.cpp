#include "tissue/biology/EndotheliumParameters.h"

#include "tissue/biology/EndotheliumScenario.h"

namespace restenosis {

void EndotheliumParameters::describe(ParameterVisitor& p) {
  p.choice(scenario, endotheliumScenarioNames(),
           {.key = "scenario",
            .source = "T6",
            .description = "how the endothelium returns: coverage against time"});
  p.quantity(maturationTime, {.key = "maturationTime",
                              .unit = "d",
                              .minimum = 0,
                              .maximum = 1e6,
                              .source = "T6",
                              .description = "time in which new endothelium comes to make all of its nitric "
                                             "oxide but 1/e; 0: at once"});
  p.quantity(nitricOxideReach, {.key = "nitricOxideReach",
                                .unit = "um",
                                .minimum = 0,
                                .maximum = 10000,
                                .source = "T6",
                                .description = "distance over which nitric oxide falls to 1/e in the tissue; "
                                               "0: it acts on the covered cell alone"});
  p.quantity(nitricOxideThreshold, {.key = "nitricOxideThreshold",
                                    .unit = "nmol/mm^3",
                                    .minimum = 0,
                                    .maximum = 1e6,
                                    .minimumAllowed = false,
                                    .source = "ISR3D",
                                    .description = "nitric oxide that sends a cell to rest"});
  p.quantity(nitricOxideSlope, {.key = "nitricOxideSlope",
                                .unit = "nmol/mm^3/Pa",
                                .minimum = 0,
                                .minimumAllowed = false,
                                .source = "ISR3D",
                                .description = "nitric oxide over wall shear stress where that is low"});
  p.quantity(nitricOxideTransition, {.key = "nitricOxideTransition",
                                     .unit = "Pa",
                                     .minimum = 0,
                                     .source = "ISR3D",
                                     .description = "wall shear stress above which a parabola holds: "
                                                    "nitricOxideConstant + nitricOxideFirst w + "
                                                    "nitricOxideSecond w^2"});
  p.quantity(nitricOxideConstant, {.key = "nitricOxideConstant",
                                   .unit = "nmol/mm^3",
                                   .source = "ISR3D",
                                   .description = "constant of the parabola"});
  p.quantity(nitricOxideFirst, {.key = "nitricOxideFirst",
                                .unit = "nmol/mm^3/Pa",
                                .source = "ISR3D",
                                .description = "first coefficient of the parabola"});
  p.quantity(nitricOxideSecond, {.key = "nitricOxideSecond",
                                 .unit = "nmol/mm^3/Pa^2",
                                 .minimum = 0,
                                 .minimumAllowed = false,
                                 .source = "ISR3D",
                                 .description = "second coefficient of the parabola"});
}

}  // namespace restenosis
