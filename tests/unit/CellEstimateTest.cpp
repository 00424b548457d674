#include <gtest/gtest.h>

#include <numbers>

#include "bridge/flow/foam/CellEstimate.h"

namespace restenosis {
namespace {

constexpr double pi = std::numbers::pi, cubicMm = 1e-9, squareMm = 1e-6;

/// What checkMesh counts in lumens of many shapes, of the fidelities that they were meshed with.
TEST(CellEstimate, IsThatOfTheMeshersCells) {
  struct Mesh {
    const char* lumen;
    const char* fidelity;
    double volume, side, cells;  // [mm^3], [mm^2]
  };
  for (const Mesh& mesh :
       {Mesh{"tube", "standard", 11.45, pi * 1.8 * 4.5, 109200},
        Mesh{"tube", "draft", 15.23, pi * 1.8 * 6, 47436}, Mesh{"narrow tube", "draft", 4.70, pi * 6, 20636},
        Mesh{"narrow tube", "standard", 4.70, pi * 6, 59600},
        Mesh{"oval tube", "draft", 12.19, 5.39 * 6, 38860},
        Mesh{"spring", "draft", 81.31, 2 * 81.31 / 0.9, 241256},
        Mesh{"thin spring", "draft", 15.04, 2 * 15.04 / 0.5, 62527}}) {
    const LumenSize size{mesh.volume * cubicMm, mesh.side * squareMm, 0};
    const double expected = expectedCells(size, FoamSettings::forFidelity(mesh.fidelity));
    EXPECT_NEAR(expected / mesh.cells, 1, 0.06) << mesh.lumen << ", " << mesh.fidelity;
  }
}

TEST(CellEstimate, GrowsByWhatIsRefinedAndNotBeyondIt) {
  FoamSettings settings = FoamSettings::forFidelity("draft");
  const LumenSize wide{pi * cubicMm, 2 * pi * squareMm, 0};  // a tube of radius 1 mm
  settings.wallLevel = settings.strutLevel = 0;
  const double core = expectedCells(wide, settings);
  EXPECT_NEAR(core, wide.volume / std::pow(settings.cellSize, 3), 1e-6 * core);
  settings.wallLevel = settings.strutLevel = 1;
  EXPECT_GT(expectedCells(wide, settings), 1.5 * core);
  settings.bufferCells = 1000;  // all of the lumen
  EXPECT_NEAR(expectedCells(wide, settings), 8 * core, 1e-6 * core);
  settings.bufferCells = 1;
  settings.strutLevel = 2;
  LumenSize stented = wide;
  std::swap(stented.strutArea, stented.wallArea);
  EXPECT_GT(expectedCells(stented, settings), 2 * expectedCells(wide, settings));
  EXPECT_LT(expectedCells(stented, settings), 64 * core);
}

}  // namespace
}  // namespace restenosis
