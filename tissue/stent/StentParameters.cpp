#include "tissue/stent/StentParameters.h"

#include <array>

#include "tissue/parameters/NamedTable.h"
#include "tissue/stent/StentDesign.h"

namespace restenosis {
namespace {

constexpr std::array outerLaminae{Named<bool>{"free", false}, Named<bool>{"fixed", true}};

}  // namespace

bool StentParameters::fixesOuterLamina() const {
  return findNamed(outerLaminae, "stent.outerLamina", outerLamina).value;
}

void StentParameters::describe(ParameterVisitor& p) {
  p.choice(design, stentDesignNames(),
           {.key = "design",
            .source = "T6",
            .description = "one ring halfway along; rings; rings joined by straight "
                           "links; a helix; sinusoidal rings joined by links"});
  p.file(file,
         {.key = "file",
          .source = "none",
          .description = "surface of the struts (.stl, .vtp, .ply or .obj), or CSV table of obstacle agents "
                         "(x, y, z, radius in um), instead of a design"});
  p.choice(fileUnit, {"m", "cm", "mm", "um"},
           {.key = "fileUnit", .source = "none", .description = "length unit of file where it is a surface"});
  p.quantity(length, {.key = "length",
                      .unit = "mm",
                      .minimum = 0,
                      .maximum = 1000,
                      .minimumAllowed = false,
                      .source = "T6",
                      .description = "length of the stent, centred in the vessel"});
  p.quantity(strutWidth, {.key = "strutWidth",
                          .unit = "mm",
                          .minimum = 0.01,
                          .maximum = 1,
                          .source = "ISR3D",
                          .description = "width of a strut along the surface"});
  p.quantity(strutThickness, {.key = "strutThickness",
                              .unit = "mm",
                              .minimum = 0.01,
                              .maximum = 1,
                              .source = "ISR3D",
                              .description = "thickness of a strut along the radius"});
  p.choice(strutShape, {"square", "round"},
           {.key = "strutShape", .source = "ISR3D", .description = "cross-section of a strut"});
  p.integer(ringCount, {.key = "ringCount",
                        .minimum = 1,
                        .maximum = 100,
                        .source = "assumed",
                        .description = "number of rings"});
  p.integer(linkCount, {.key = "linkCount",
                        .minimum = 1,
                        .maximum = 24,
                        .source = "assumed",
                        .description = "links between two neighbouring rings"});
  p.integer(ringWaves, {.key = "ringWaves",
                        .minimum = 1,
                        .maximum = 24,
                        .source = "assumed",
                        .description = "waves around a sinusoidal ring"});
  p.quantity(ringAmplitude, {.key = "ringAmplitude",
                             .unit = "mm",
                             .minimum = 0,
                             .maximum = 5,
                             .source = "assumed",
                             .description = "axial amplitude of a sinusoidal ring"});
  p.quantity(helixTurns, {.key = "helixTurns",
                          .minimum = 0.1,
                          .maximum = 100,
                          .source = "ISR3D",
                          .description = "turns of a helix over the stent's length"});
  p.quantity(deploymentDepth, {.key = "deploymentDepth",
                               .unit = "um",
                               .minimum = 0,
                               .maximum = 1000,
                               .source = "ISR3D",
                               .description = "final depth of the struts' outer face beyond the "
                                              "undeformed lumen (injury 1 to 4: 90, 110, 110, 130)"});
  p.integer(deploymentSteps, {.key = "deploymentSteps",
                              .minimum = 1,
                              .maximum = 100000,
                              .source = "T6",
                              .description = "equal steps of deployment; the wall relaxes after each"});
  p.choice(outerLamina, namesOf(outerLaminae),
           {.key = "outerLamina",
            .source = "assumed",
            .description = "whether the EEL may move during deployment"});
}

}  // namespace restenosis
