#include "bridge/flow/foam/FoamSettings.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace restenosis {
namespace {

struct Level {
  std::string_view fidelity;
  double cellSize;  // [m]
  int wallLevel, strutLevel;
  int bufferCells, snapIterations;
  double tolerance;
};

/// Cell sizes at core, wall and strut: 90, 45, 22.5; 60, 30, 15; 45, 22.5, 11.25 um.
constexpr std::array levels = {Level{"draft", 90e-6, 1, 2, 1, 3, 1e-3},
                               Level{"standard", 60e-6, 1, 2, 2, 5, 1e-4},
                               Level{"reference", 45e-6, 1, 2, 2, 5, 1e-4}};

}  // namespace

double FoamSettings::wallCell() const { return cellSize / std::exp2(static_cast<double>(wallLevel)); }
double FoamSettings::strutCell() const { return cellSize / std::exp2(static_cast<double>(strutLevel)); }

void FoamSettings::describe(ParameterVisitor& p) {
  p.choice(mesh, {"snappyHexMesh", "oGrid"},
           {.key = "mesh",
            .source = "docs/model/flow.md",
            .description = "made by snappyHexMesh, or an O-grid where the lumen lies along z and can be seen "
                           "from its axis, and else by snappyHexMesh"});
  p.quantity(cellSize, {.key = "cellSize",
                        .unit = "um",
                        .minimum = 0,
                        .maximum = 10000,
                        .minimumAllowed = false,
                        .source = "assumed",
                        .description = "cell size in the core of the lumen"});
  p.integer(wallLevel, {.key = "wallLevel",
                        .minimum = 0,
                        .maximum = 8,
                        .source = "assumed",
                        .description = "how often cells are halved at the wall"});
  p.integer(strutLevel, {.key = "strutLevel",
                         .minimum = 0,
                         .maximum = 8,
                         .source = "assumed",
                         .description = "how often cells are halved at struts"});
  p.integer(bufferCells, {.key = "bufferCells",
                          .minimum = 1,
                          .maximum = 16,
                          .source = "docs/developer/decisions.md",
                          .description = "rows of cells between one size and the next"});
  p.integer(snapIterations, {.key = "snapIterations",
                             .minimum = 1,
                             .maximum = 100,
                             .source = "docs/developer/decisions.md",
                             .description = "iterations that move the mesh's wall onto the surface"});
  p.quantity(tolerance, {.key = "tolerance",
                         .minimum = 0,
                         .maximum = 1,
                         .minimumAllowed = false,
                         .source = "assumed",
                         .description = "residual of U and p at which the solution counts as converged"});
  p.quantity(pressureDrivenTolerance,
             {.key = "pressureDrivenTolerance",
              .minimum = 0,
              .maximum = 1,
              .minimumAllowed = false,
              .source = "docs/results/verification.md",
              .description = "the same at a fixed pressure gradient, where the flow rate settles last"});
  p.integer(iterations, {.key = "iterations",
                         .minimum = 1,
                         .source = "assumed",
                         .description = "most iterations at a fixed flow rate"});
  p.integer(pressureDrivenIterations, {.key = "pressureDrivenIterations",
                                       .minimum = 1,
                                       .source = "assumed",
                                       .description = "most iterations at a fixed pressure gradient"});
  p.quantity(relaxation, {.key = "relaxation",
                          .minimum = 0,
                          .maximum = 1,
                          .minimumAllowed = false,
                          .source = "assumed",
                          .description = "relaxation factor of U; the steady state depends on it a little"});
  p.quantity(
      nonOrthogonal,
      {.key = "nonOrthogonal",
       .minimum = 0,
       .maximum = 1,
       .source = "docs/developer/decisions.md",
       .description = "share of the correction of gradients between cells that do not face each other"});
  p.quantity(volumeTolerance, {.key = "volumeTolerance",
                               .minimum = 0,
                               .maximum = 1,
                               .source = "assumed",
                               .description = "largest relative difference of mesh and surface volume"});
  p.quantity(
      endAreaTolerance,
      {.key = "endAreaTolerance",
       .minimum = 0,
       .maximum = 1,
       .source = "assumed",
       .description = "largest relative difference of an end's area in mesh and surface, beside half a "
                      "wall cell along its rim that the mesh may lack"});
  p.integer(skewFaces, {.key = "skewFaces",
                        .minimum = 0,
                        .source = "assumed",
                        .description = "most faces that checkMesh may find highly skew (above 4)"});
  p.quantity(skewness,
             {.key = "skewness",
              .minimum = 4,
              .source = "assumed",
              .description = "largest skewness of a face; snappyHexMesh itself allows 20 on boundaries"});
  p.quantity(massTolerance, {.key = "massTolerance",
                             .minimum = 0,
                             .maximum = 1,
                             .source = "assumed",
                             .description = "largest relative error of the flow rates at the ends"});
  p.boolean(warmStart, {.key = "warmStart",
                        .source = "docs/results/flow.md",
                        .description = "start from the former flow instead of from rest"});
  p.quantity(morphMovement,
             {.key = "morphMovement",
              .minimum = 0,
              .maximum = 10,
              .source = "docs/results/flow.md",
              .description = "largest movement of the wall, in cells there, that a mesh may follow"});
  p.quantity(morphDeparture,
             {.key = "morphDeparture",
              .minimum = 0,
              .maximum = 10,
              .source = "docs/results/flow.md",
              .description = "largest distance of a moved mesh's wall from the lumen, in cells there"});
  p.quantity(morphNonOrthogonality,
             {.key = "morphNonOrthogonality",
              .minimum = 0,
              .maximum = 90,
              .source = "assumed",
              .description = "largest angle [degrees] between faces and the lines between cells "
                             "that a moved mesh may have; snappyHexMesh allows the same"});
  p.quantity(maximumCells, {.key = "maximumCells",
                            .minimum = 1,
                            .source = "assumed",
                            .description = "estimated number of cells above which meshing is refused"});
  p.quantity(minimumCellsAcross, {.key = "minimumCellsAcross",
                                  .minimum = 1,
                                  .source = "assumed",
                                  .description = "fewest core cells across the inlet before the run"});
  p.integer(beatSteps, {.key = "beatSteps",
                        .minimum = 20,
                        .maximum = 100000,
                        .source = "docs/results/beats.md",
                        .description = "time steps of a beat, with flow.waveform"});
  p.integer(beatCorrectors, {.key = "beatCorrectors",
                             .minimum = 1,
                             .maximum = 100,
                             .source = "docs/results/beats.md",
                             .description = "corrections of velocity and pressure in such a step"});
  p.quantity(
      silenceLimit,
      {.key = "silenceLimit",
       .unit = "min",
       .minimum = 0,
       .maximum = 10000,
       .minimumAllowed = false,
       .source = "assumed",
       .description = "a program of OpenFOAM whose log has not grown for so long hangs, and is ended"});
}

FoamSettings FoamSettings::forFidelity(std::string_view fidelity) {
  for (const Level& level : levels)
    if (level.fidelity == fidelity) {
      FoamSettings settings;
      settings.cellSize = level.cellSize;
      settings.wallLevel = level.wallLevel;
      settings.strutLevel = level.strutLevel;
      settings.bufferCells = level.bufferCells;
      settings.snapIterations = level.snapIterations;
      settings.tolerance = level.tolerance;
      return settings;
    }
  throw std::invalid_argument(
      fmt::format("there is no fidelity '{}'; valid names: draft, standard, reference", fidelity));
}

}  // namespace restenosis
