#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <numbers>

#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/VesselAxis.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/ViewState.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class BentRun : public WholeProgram {
 protected:
  vtkPolyData* read(const std::string& file) {
    reader_->SetFileName((folder / file).c_str());
    reader_->Modified();
    reader_->Update();
    return reader_->GetOutput();
  }

  /// Writes axis.csv: an arc of a radius of 5 mm and a length, turned about z from y towards x.
  void writeAxis(double length, double turn) {
    std::string table = "x,y,z\n";
    for (int n = 0; n <= 20; ++n) {
      const double angle = n * length / 20 / 5, across = 5 * (1 - std::cos(angle));
      table +=
          fmt::format("{},{},{}\n", std::sin(turn) * across, std::cos(turn) * across, 5 * std::sin(angle));
    }
    writeText(folder / "axis.csv", table);
  }
  /// The scene of a wall of large cells, one step; `vessel`: what its lumen follows.
  std::string wall(const std::string& vessel) {
    return scene("bent", R"([scene]
title = "Bent"
duration = "1 h"
step = "1 h"
[mechanics]
contactLaw = "hertzNeoHookean"
[vessel]
wallThickness = "0.2 mm"
cellRadius = "30 um"
)" + vessel);
  }

  vtkNew<vtkXMLPolyDataReader> reader_;
};

TEST_F(BentRun, GrowsTissueAsAboutAStraightAxisAndShowsItBent) {
  const std::string straight = scene("straight", tinyScene);
  const std::vector<std::string> bend{"--set", "vessel.curvatureRadius=5 mm"};
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "straight"}), 0);
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "bent", bend[0], bend[1]}), 0);
  EXPECT_EQ(digest("bent"), digest("straight"));
  EXPECT_EQ(readText(folder / "bent/profile.csv"), readText(folder / "straight/profile.csv"));

  const Centreline axis = Centreline::arc(5e-3, 0, 10e-3);
  vtkPolyData* tissue = read("bent/tissue/tissue_000000.vtp");
  vtkDataArray* places = tissue->GetPointData()->GetArray("straightPosition");
  ASSERT_NE(places, nullptr);
  for (vtkIdType n = 0; n < tissue->GetNumberOfPoints(); n += 100)
    EXPECT_NEAR((axis.toBent(Vec3(places->GetTuple3(n))) - Vec3(tissue->GetPoint(n))).norm(), 0, 1e-9);
  EXPECT_EQ(read("straight/tissue/tissue_000000.vtp")->GetPointData()->GetArray("straightPosition"), nullptr);
}

TEST_F(BentRun, HasMoreStressOnTheOuterSide) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string tube = scene("tube", R"([scene]
title = "Tube"
duration = "1 h"
step = "1 h"
fidelity = "draft"
[vessel]
length = "1.2 mm"
lumenDiameter = "1.8 mm"
curvatureRadius = "10 mm"
[foam]
cellSize = "150 um"
[flow]
backend = "foam"
meanVelocity = "0.133 m/s"
straightEnds = "1.8 mm"
)");
  ASSERT_EXIT_STATUS(run({"run", tube, "-o", "out"}), 0);
  vtkPolyData* lumen = read("out/lumen/lumen_000000.vtp");
  vtkDataArray *places = lumen->GetPointData()->GetArray("straightPosition"),
               *stress = lumen->GetCellData()->GetArray("WSS"),
               *traction = lumen->GetCellData()->GetArray("traction");
  double inner = 0, outer = 0;
  for (vtkIdType cell = 0; cell < lumen->GetNumberOfCells(); ++cell) {
    EXPECT_NEAR(Vec3(traction->GetTuple3(cell)).norm(), stress->GetTuple1(cell), 1e-5);
    const double y = places->GetTuple3(lumen->GetCell(cell)->GetPointId(0))[1];
    (y > 0 ? inner : outer) += stress->GetTuple1(cell);
  }
  EXPECT_GT(outer, 1.03 * inner);
}

TEST_F(BentRun, AlongACentrelineIsThatAlongItsArc) {
  writeAxis(0.24, 0);  // as long as the vessel of tinyScene
  const std::string straight = scene("straight", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "arc", "--set", "vessel.curvatureRadius=5 mm"}), 0);
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "line", "--set", "vessel.centreline=axis.csv"}), 0);
  EXPECT_NEAR(
      summary("line")["final"]["agents"].get<double>() / summary("arc")["final"]["agents"].get<double>(), 1,
      0.02);
  const ProcessEnd end =
      run({"check", straight, "--set", "vessel.centreline=axis.csv", "--set", "vessel.centrelineUnit=cm"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("'centreline' is 2.4 mm long, but 'length' is 0.24 mm"), std::string::npos)
      << end.err;
}

TEST_F(BentRun, AroundABentSurfaceFindsItsAxis) {
  const Centreline axis = Centreline::arc(20e-3, 0, 1.2e-3);
  VesselParameters vessel;
  vessel.length = 1.2e-3;
  writeStl(folder / "bent.stl", bentAlong(axis, cylinderSurface(vessel, {60e-6, 60e-6})), 1e-3);
  const std::string quick = wall("lumenSurface = \"bent.stl\"\n");
  ASSERT_EXIT_STATUS(run({"run", quick, "-o", "out", "--set", "output.pictures=false"}), 0);
  const CsvColumns profile(folder / "out/profile.csv");
  EXPECT_NEAR(1e-3 * profile.values.at("z_mm").back().value() / vessel.length, 1, 5e-3);
  EXPECT_NE(read("out/tissue/tissue_000000.vtp")->GetPointData()->GetArray("straightPosition"), nullptr);
}

TEST_F(BentRun, IsCutInTheStateOfParaViewWhereItBends) {
  if (!picturesPackagesPresent())
    GTEST_SKIP() << "install python3-matplotlib and python3-vtk9 to run this test";
  writeAxis(1.2, std::numbers::pi / 4);
  const std::string bent = wall("centreline = \"axis.csv\"\nlumenDiameter = \"1.8 mm\"\n");
  ASSERT_EXIT_STATUS(run({"run", bent, "-o", "out", "--set", "output.pictures=false"}), 0);
  checkView(folder / "out");
}

TEST_F(BentRun, TooSharplyIsRefused) {
  const std::string tiny = scene("tiny", tinyScene);
  const ProcessEnd end = run({"check", tiny, "--set", "vessel.curvatureRadius=0.5 mm"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("'curvatureRadius' in [vessel] is 0.5 mm; a vessel that reaches"), std::string::npos)
      << end.err;
}

}  // namespace
}  // namespace restenosis
