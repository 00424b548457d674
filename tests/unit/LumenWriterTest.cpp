#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>

#include "bridge/output/LumenWriter.h"
#include "tests/support/SyntheticResults.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

class LumenWriter : public ::testing::Test {
 protected:
  vtkPolyData* written(const TriSurface& lumen, const FlowSolution* flow) {
    writeLumen(folder_ / "lumen.vtp", lumen, flow, 0);
    reader_->SetFileName((folder_ / "lumen.vtp").c_str());
    reader_->Modified();  // the file may have been written before
    reader_->Update();
    return reader_->GetOutput();
  }

  TemporaryFolder folder_;
  vtkNew<vtkXMLPolyDataReader> reader_;
};

std::size_t sideCount(const TriSurface& lumen) {
  return static_cast<std::size_t>(std::ranges::count_if(
      lumen.region, [](SurfaceRegion r) { return r == SurfaceRegion::wall || r == SurfaceRegion::strut; }));
}

TEST_F(LumenWriter, WritesTheOpenTube) {
  const auto lumen = SyntheticResults().lumen(0);
  auto* data = written(lumen, nullptr);
  EXPECT_EQ(static_cast<std::size_t>(data->GetNumberOfCells()), sideCount(lumen));
  // The two centres of the ends are used by no wall triangle.
  EXPECT_EQ(static_cast<std::size_t>(data->GetNumberOfPoints()), lumen.vertices.size() - 2);
  EXPECT_EQ(data->GetCellData()->GetArray("region")->GetRange()[1], 1.0);
  EXPECT_NEAR(data->GetPointData()->GetArray("lumenRadius")->GetTuple1(0), 0.9e-3, 1e-6);
}

TEST_F(LumenWriter, SaysThatStressIsNotKnownBeforeASolve) {
  auto* data = written(SyntheticResults().lumen(0), nullptr);
  EXPECT_TRUE(std::isnan(data->GetCellData()->GetArray("WSS")->GetTuple1(0)));
}

TEST_F(LumenWriter, CarriesTheNearestFacesTraction) {
  const auto lumen = SyntheticResults().lumen(0);
  FlowSolution flow;
  // Faces that are not the surface's: two rings of points, slower upstream.
  for (int k = 0; k < 60; ++k) {
    const double theta = 2 * M_PI * k / 60;
    const Vec3 radial(0.9e-3 * std::cos(theta), 0.9e-3 * std::sin(theta), 0);
    flow.wall.push_back({radial + Vec3(0, 0, 0.3e-3), 1e-9, Vec3(0, 0.3, 0.4), SurfaceRegion::wall});
    flow.wall.push_back({radial + Vec3(0, 0, 0.9e-3), 1e-9, Vec3(0, 0, 2), SurfaceRegion::wall});
  }
  auto* data = written(lumen, &flow);
  auto* wss = data->GetCellData()->GetArray("WSS");
  auto* traction = data->GetCellData()->GetArray("traction");
  for (vtkIdType t = 0; t < data->GetNumberOfCells(); ++t) {
    double box[6];
    data->GetCellBounds(t, box);
    const bool upstream = box[5]<0.58e-3, downstream = box[4]> 0.62e-3;
    if (upstream) {
      ASSERT_FLOAT_EQ(static_cast<float>(wss->GetTuple1(t)), 0.5f);
    }
    if (downstream) {
      ASSERT_FLOAT_EQ(static_cast<float>(wss->GetTuple1(t)), 2.0f);
    }
    if (upstream) {
      ASSERT_FLOAT_EQ(static_cast<float>(traction->GetComponent(t, 1)), 0.3f);
    }
  }
}

TEST_F(LumenWriter, BesideAStrutTheWallShowsTheWallsStress) {
  const auto lumen = support::stentedTube(0.9e-3, 1.2e-3, 90e-6);
  FlowSolution flow;
  const auto addFace = [&](std::size_t t, double stress) {
    flow.wall.push_back({lumen.centre(t), lumen.areaVector(t).norm(), {0, 0, stress}, lumen.region[t]});
  };
  // Struts are resolved finely, the wall coarsely, so that the nearest face of a wall's triangle beside a
  // strut is one of the strut.
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] == SurfaceRegion::strut) addFace(t, 5);
    if (lumen.region[t] == SurfaceRegion::wall && std::abs(lumen.centre(t).z() - 0.6e-3) > 0.4e-3)
      addFace(t, 1);
  }
  auto* cells = written(lumen, &flow)->GetCellData();
  const auto shown = [&](vtkIdType t) { return cells->GetArray("WSS")->GetTuple1(t); };
  const auto expectByRegion = [&](double wall, double strut) {
    for (vtkIdType t = 0; t < cells->GetNumberOfTuples(); ++t)
      ASSERT_EQ(shown(t), cells->GetArray("region")->GetTuple1(t) == 1.0 ? strut : wall);
  };
  expectByRegion(1, 5);
  std::erase_if(flow.wall, [](const WallFace& face) { return face.region == SurfaceRegion::strut; });
  cells = written(lumen, &flow)->GetCellData();
  expectByRegion(1, 1);  // a flow in which no strut was bare
}

}  // namespace
}  // namespace restenosis
