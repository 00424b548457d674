#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>

#include "bridge/flow/foam/WallPatch.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// One face of 2 mm x 1 mm in the plane x = 1 mm.
void writePatch(const std::filesystem::path& file, const char* field, const Vec3& stress) {
  vtkNew<vtkPoints> points;
  for (const auto& p : {Vec3(1e-3, 0, 0), Vec3(1e-3, 1e-3, 0), Vec3(1e-3, 1e-3, 2e-3), Vec3(1e-3, 0, 2e-3)})
    points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> polygons;
  const vtkIdType corners[] = {0, 1, 2, 3};
  polygons->InsertNextCell(4, corners);
  vtkNew<vtkFloatArray> values;
  values->SetName(field);
  values->SetNumberOfComponents(3);
  values->InsertNextTuple(stress.data());
  vtkNew<vtkPolyData> patch;
  patch->SetPoints(points);
  patch->SetPolys(polygons);
  patch->GetCellData()->AddArray(values);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(patch);
  writer->Write();
}

TEST(WallPatch, becomesTraction) {
  const TemporaryFolder scratch;
  const auto file = scratch.path() / "wall.vtp";
  writePatch(file, "wallShearStress", {5e-5, 0, -1.6e-3});  // the part along the normal is left out
  std::vector<WallFace> faces;
  appendWallPatch(file, SurfaceRegion::strut, 1000.0, faces);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(faces[0].area, 2e-6, 1e-12);
  EXPECT_NEAR((faces[0].centre - Vec3(1e-3, 0.5e-3, 1e-3)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((faces[0].traction - Vec3(0, 0, 1.6)).norm(), 0.0, 1e-6);
  EXPECT_EQ(faces[0].region, SurfaceRegion::strut);
}

TEST(WallPatch, badFilesAreRefused) {
  const TemporaryFolder scratch;
  const auto file = scratch.path() / "wall.vtp";
  std::vector<WallFace> faces;
  EXPECT_THROW(appendWallPatch(file, SurfaceRegion::wall, 1000.0, faces), std::runtime_error);
  writePatch(file, "p", {0, 0, 0});
  EXPECT_THROW(appendWallPatch(file, SurfaceRegion::wall, 1000.0, faces), std::runtime_error);
  writePatch(file, "wallShearStress", {0, 0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_THROW(appendWallPatch(file, SurfaceRegion::wall, 1000.0, faces), std::runtime_error);
}

}  // namespace
}  // namespace restenosis
