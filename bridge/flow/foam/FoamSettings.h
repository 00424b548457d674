#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// How finely and how exactly the OpenFOAM backend works.
struct FoamSettings {
  static constexpr std::string_view section = "foam";
  static constexpr std::string_view summary =
      "Mesh and solver settings of the OpenFOAM backend; cell sizes, buffer, snapping and tolerance not "
      "given are "
      "those of scene.fidelity";

  std::string mesh = "snappyHexMesh";             ///< or oGrid
  double cellSize = 60e-6;                        ///< cell size in the core of the lumen [m]
  std::int64_t wallLevel = 1;                     ///< the cell size at the wall is cellSize / 2^level
  std::int64_t strutLevel = 2;                    ///< the same at struts
  std::int64_t bufferCells = 2;                   ///< rows of cells between one level and the next
  std::int64_t snapIterations = 5;                ///< of moving the mesh's wall onto the surface
  double tolerance = 1e-4;                        ///< residual at which the solution counts as converged
  double pressureDrivenTolerance = 1e-5;          ///< the same at a fixed pressure gradient
  std::int64_t iterations = 2000;                 ///< most iterations at a fixed flow rate
  std::int64_t pressureDrivenIterations = 10000;  ///< the same at a fixed pressure gradient
  double relaxation = 0.8;                        ///< of U
  double nonOrthogonal = 1.0;                     ///< share of the non-orthogonal correction of gradients
  double volumeTolerance = 0.02;                  ///< mesh volume against the surface's volume
  double endAreaTolerance = 0.05;                 ///< area of the mesh's ends against the surface's
  std::int64_t skewFaces = 10;                    ///< most faces of a skewness above 4
  double skewness = 20;                           ///< largest skewness
  double massTolerance = 1e-3;        ///< outflow against inflow, and inflow against the flow rate asked for
  bool warmStart = true;              ///< from the former flow, where there is one
  double morphMovement = 0.5;         ///< largest movement of the wall that a mesh may follow, in wall cells
  double morphDeparture = 0.5;        ///< largest distance of the moved wall from the lumen, in wall cells
  double morphNonOrthogonality = 65;  ///< largest of a moved mesh [degrees]
  double maximumCells = 6e6;          ///< estimate above which meshing is refused
  double minimumCellsAcross = 8;      ///< fewest core cells across the inlet before the run
  std::int64_t beatSteps = 100;       ///< time steps of a beat
  std::int64_t beatCorrectors = 2;    ///< PIMPLE's outer corrections of such a step
  double silenceLimit = 1800;         ///< a program whose log has not grown for so long hangs [s]

  bool operator==(const FoamSettings&) const = default;
  /// Size of the cells at the wall [m].
  double wallCell() const;
  double strutCell() const;  ///< the same at struts
  void describe(ParameterVisitor& p);
  /// The settings of a fidelity level: draft, standard or reference. Throws std::invalid_argument for others.
  static FoamSettings forFidelity(std::string_view fidelity);
};

}  // namespace restenosis
