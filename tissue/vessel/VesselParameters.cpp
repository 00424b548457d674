#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

void VesselParameters::describe(ParameterVisitor& p) {
  // First: a surface has its own length and diameter, and so may a centreline
  p.file(lumenSurface, {.key = "lumenSurface",
                        .source = "none",
                        .description = "surface of the lumen (.stl, .vtp, .ply or .obj) instead of a "
                                       "cylinder; tissue is built outwards from it; length "
                                       "and lumenDiameter are then the surface's own unless given"});
  p.choice(lumenSurfaceUnit, {"m", "cm", "mm", "um"},
           {.key = "lumenSurfaceUnit", .source = "none", .description = "length unit of lumenSurface"});
  p.file(centreline,
         {.key = "centreline",
          .source = "none",
          .description = "axis of a bent vessel: a CSV table (x, y, z, and radius of the lumen where it is "
                         "known), or one line in VTK's format, as VMTK writes it (.vtp)"});
  p.choice(centrelineUnit, {"m", "cm", "mm", "um"},
           {.key = "centrelineUnit", .source = "assumed", .description = "length unit of 'centreline'"});
  const bool cylinder = lumenSurface.empty() && centreline.empty();
  p.quantity(length,
             {.key = "length",
              .unit = "mm",
              .minimum = 0,
              .maximum = 1000,
              .minimumAllowed = false,
              .required = cylinder,
              .source = "T6",
              .description = "length of the vessel; required unless lumenSurface or centreline is given"});
  p.quantity(lumenDiameter, {.key = "lumenDiameter",
                             .unit = "mm",
                             .minimum = 0,
                             .maximum = 50,
                             .minimumAllowed = false,
                             .required = cylinder,
                             .source = "T6",
                             .description = "diameter of the lumen before stenting; required unless "
                                            "lumenSurface, or a centreline with radii, is given"});
  p.quantity(wallThickness, {.key = "wallThickness",
                             .unit = "mm",
                             .minimum = 0,
                             .maximum = 10,
                             .minimumAllowed = false,
                             .source = "T6",
                             .description = "thickness of the wall, IEL and EEL included"});
  p.quantity(cellRadius, {.key = "cellRadius",
                          .unit = "um",
                          .minimum = 1,
                          .maximum = 200,
                          .source = "ISR3D",
                          .description = "mean radius of the wall's agents"});
  p.quantity(radiusSpread, {.key = "radiusSpread",
                            .minimum = 0,
                            .maximum = 0.3,
                            .source = "assumed",
                            .description = "standard deviation of the radius over its mean"});
  p.quantity(packingFraction,
             {.key = "packingFraction",
              .minimum = 0.1,
              .maximum = 0.63,
              .source = "assumed",
              .description = "volume of all wall agents over volume of the wall; above 0.63 the "
                             "packing jams and pushes cells through the laminae"});
  p.quantity(laminaCoverage, {.key = "laminaCoverage",
                              .minimum = 0.1,
                              .maximum = 0.85,
                              .source = "assumed",
                              .description = "area of a lamina's agents over the area of the lamina"});
  p.quantity(bondRange,
             {.key = "bondRange",
              .minimum = 0,
              .maximum = 1.5,
              .source = "assumed",
              .description = "agents nearer than this times R1 + R2 are bonded in the packed wall; "
                             "0 makes no bonds"});
  p.quantity(fixedEnds, {.key = "fixedEnds",
                         .minimum = 0,
                         .maximum = 100,
                         .source = "assumed",
                         .description = "agents with centres within this many cell radii of an end of the "
                                        "vessel never move: they stand for the vessel beyond"});
  p.quantity(stenosis, {.key = "stenosis",
                        .minimum = 0,
                        .maximum = 0.99,
                        .source = "assumed",
                        .description = "share of the lumen diameter removed halfway along, cosine-shaped; "
                                       "only in scenes without tissue"});
  p.quantity(stenosisLength, {.key = "stenosisLength",
                              .unit = "mm",
                              .minimum = 0,
                              .maximum = 1000,
                              .minimumAllowed = false,
                              .source = "assumed",
                              .description = "length of the stenosis"});
  p.quantity(curvatureRadius,
             {.key = "curvatureRadius",
              .unit = "mm",
              .minimum = 0,
              .maximum = 10000,
              .source = "docs/model/curved.md",
              .description = "radius of the arc that the vessel's axis is bent to; 0: straight"});
  p.file(agents,
         {.key = "agents",
          .source = "none",
          .description = "CSV table of agents (x, y, z, radius in um; kind, birthRadius) to load instead of "
                         "packing"});
}

}  // namespace restenosis
