#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "bridge/surface/Centreline.h"
#include "tests/support/OpenFoamPresent.h"
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

TEST_F(BentRun, TooSharplyIsRefused) {
  const std::string tiny = scene("tiny", tinyScene);
  const ProcessEnd end = run({"check", tiny, "--set", "vessel.curvatureRadius=0.5 mm"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("'curvatureRadius' in [vessel] is 0.5 mm; a vessel that reaches"), std::string::npos)
      << end.err;
}

}  // namespace
}  // namespace restenosis
