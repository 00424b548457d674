#include "bridge/flow/FlowParameters.h"

#include <array>
#include <numbers>

#include "bridge/flow/FlowBackendNames.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::array drives{
    Named<FlowConditions::Drive>{"flowRate", FlowConditions::Drive::flowRate},
    Named<FlowConditions::Drive>{"pressureGradient", FlowConditions::Drive::pressureGradient}};

}  // namespace

FlowConditions::Drive FlowParameters::keeps() const { return findNamed(drives, "flow.drive", drive).value; }

void FlowParameters::describe(ParameterVisitor& p) {
  p.choice(backend, flowBackendNames::all(),
           {.key = "backend",
            .source = "model 8",
            .description = "OpenFOAM, lattice Boltzmann, Poiseuille from the local radius, or no flow"});
  p.choice(drive, namesOf(drives),
           {.key = "drive", .source = "model 8", .description = "what stays fixed while the lumen narrows"});
  p.quantity(meanVelocity, {.key = "meanVelocity",
                            .unit = "m/s",
                            .minimum = slowest,
                            .maximum = 10,
                            .source = "ISR3D",
                            .description = "mean velocity in the undeformed lumen; sets the flow rate"});
  p.quantity(pressureGradient,
             {.key = "pressureGradient",
              .unit = "Pa/m",
              .minimum = 0,
              .maximum = 1e7,
              .source = "8 mu U / R^2",
              .description = "pressure lost along the vessel, for drive = \"pressureGradient\""});
  p.quantity(density, {.key = "density",
                       .unit = "kg/m^3",
                       .minimum = 1,
                       .maximum = 20000,
                       .source = "ISR3D",
                       .description = "density of blood"});
  p.quantity(kinematicViscosity, {.key = "kinematicViscosity",
                                  .unit = "m^2/s",
                                  .minimum = 1e-8,
                                  .maximum = 1,
                                  .source = "ISR3D",
                                  .description = "kinematic viscosity of blood"});
  p.quantity(straightEnds, {.key = "straightEnds",
                            .unit = "mm",
                            .minimum = 0,
                            .maximum = 1000,
                            .source = "assumed",
                            .description = "length of straight tube that the flow is solved in before the "
                                           "lumen's inlet and behind its outlet"});
  p.choice(crossCheck, flowBackendNames::crossChecks(),
           {.key = "crossCheck",
            .source = "assumed",
            .description = "another method, or the same with the finest cells, that solves some of the flows "
                           "too; the state does not depend on it"});
  p.quantity(crossCheckShare,
             {.key = "crossCheckShare",
              .minimum = 0,
              .maximum = 10,
              .source = "assumed",
              .description = "time for cross-checks, over that of the flow; the first and the "
                             "last solve are checked in any case"});
  p.quantity(crossCheckLimit, {.key = "crossCheckLimit",
                               .minimum = 0,
                               .maximum = 10,
                               .source = "assumed",
                               .description = "relative difference of the mean stress on smooth wall, near "
                                              "struts or on struts beyond which it is said"});
}

bool FlowParameters::isCrossChecked() const {
  return crossCheck != flowBackendNames::none && backend != flowBackendNames::none;
}

double FlowParameters::drivenVelocity(double lumenDiameter) const {
  const double radius = lumenDiameter / 2;
  return pressureGradient * radius * radius / (8 * density * kinematicViscosity);
}

double FlowParameters::reynoldsNumber(double lumenDiameter) const {
  const double velocity =
      keeps() == FlowConditions::Drive::flowRate ? meanVelocity : drivenVelocity(lumenDiameter);
  return velocity * lumenDiameter / kinematicViscosity;
}

FlowConditions FlowParameters::conditions(double lumenDiameter) const {
  return {.drive = keeps(),
          .flowRate = meanVelocity * std::numbers::pi * lumenDiameter * lumenDiameter / 4.0,
          .pressureGradient = pressureGradient,
          .density = density,
          .kinematicViscosity = kinematicViscosity};
}

}  // namespace restenosis
