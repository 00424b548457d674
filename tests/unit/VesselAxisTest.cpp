#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/LumenShape.h"
#include "bridge/surface/CentrelineFile.h"
#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/SectionAxis.h"
#include "bridge/surface/VesselAxis.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

constexpr double bend = 10e-3, arcLength = 6e-3;

class VesselAxis : public ::testing::Test {
 protected:
  VesselParameters vessel(const std::string& file) const {
    VesselParameters v;
    v.centreline = folder / file;
    v.length = arcLength;
    return v;
  }
  std::string refused(const std::string& file, const std::string& text) const {
    writeText(folder / file, text);
    try {
      readCentreline(folder / file, 1e-3);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }
  /// Points on the arc, in mm, with the radius falling from 0.9 to 0.7 mm.
  static std::vector<std::array<double, 4>> arcPoints(int count) {
    std::vector<std::array<double, 4>> points;
    for (int n = 0; n < count; ++n) {
      const double share = static_cast<double>(n) / (count - 1), angle = share * arcLength / bend;
      points.push_back(
          {0, 1e3 * bend * (1 - std::cos(angle)), 1e3 * bend * std::sin(angle), 0.9 - 0.2 * share});
    }
    return points;
  }
  void writeTable(int count, bool radii) const {
    std::string text = radii ? "x,y,z,radius\n" : "x,y,z\n";
    for (const auto& [x, y, z, r] : arcPoints(count))
      text += radii ? fmt::format("{},{},{},{}\n", x, y, z, r) : fmt::format("{},{},{}\n", x, y, z);
    writeText(folder / "arc.csv", text);
  }
  void writeVtp(int lines) const {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> radii;
    radii->SetName("MaximumInscribedSphereRadius");
    vtkNew<vtkIdList> ids;
    for (const auto& [x, y, z, r] : arcPoints(900)) {
      ids->InsertNextId(points->InsertNextPoint(x, y, z));
      radii->InsertNextValue(r);
    }
    vtkNew<vtkCellArray> cells;
    for (int n = 0; n < lines; ++n) cells->InsertNextCell(ids);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(cells);
    data->GetPointData()->AddArray(radii);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName((folder / "arc.vtp").c_str());
    writer->SetInputData(data);
    writer->Write();
  }

  TemporaryFolder folder;
};

TEST_F(VesselAxis, ThroughPointsOfAnArcIsTheArc) {
  writeTable(20, false);
  const auto axis = vesselAxis(vessel("arc.csv"));
  const Centreline arc = Centreline::arc(bend, 0, arcLength);
  EXPECT_NEAR(axis->length() / arcLength, 1, 1e-5);
  EXPECT_NEAR(sharpestRadius(vessel("arc.csv")) / bend, 1, 0.1);
  for (const Vec3& p : {Vec3(9e-4, 0, 0), Vec3(0, -9e-4, 3e-3), Vec3(5e-4, 7e-4, arcLength)})
    EXPECT_NEAR((axis->toBent(p) - arc.toBent(p)).norm(), 0, 3e-6);
  EXPECT_FALSE(hasRadiiAlong(vessel("arc.csv")));
}

TEST_F(VesselAxis, OfAPolylineHasItsRadii) {
  writeVtp(1);
  const CentrelinePoints points = readCentreline(folder / "arc.vtp", 1e-3);
  EXPECT_EQ(points.points.size(), 400U);
  EXPECT_NEAR((points.points.back() - 1e-3 * Vec3(arcPoints(2).back().data())).norm(), 0, 1e-12);
  const VesselParameters v = vessel("arc.vtp");
  ASSERT_TRUE(hasRadiiAlong(v));
  const auto radius = lumenRadius(v);
  for (const double share : {0.0, 0.3, 1.0})
    EXPECT_NEAR(radius(share * arcLength), 0.9e-3 - 0.2e-3 * share, 1e-9);
  // A frustum
  const double volume = std::numbers::pi / 3 * arcLength * (0.81 + 0.63 + 0.49) * 1e-6;
  EXPECT_NEAR(enclosedVolume(straightLumen(v)) / volume, 1, 1e-4);
  writeVtp(2);
  EXPECT_THROW(readCentreline(folder / "arc.vtp", 1e-3), std::runtime_error);
}

TEST_F(VesselAxis, OfATableThatIsWrongIsRefusedWithItsLine) {
  EXPECT_SAYS(refused("a.csv", "x,y\n0,0\n"), "a.csv:1: 'x,y' is no header of a centreline");
  EXPECT_SAYS(refused("a.csv", "x,y,z\n0,0,0\n0,0,one\n"), "a.csv:3: '0,0,one' is not 3 numbers");
  EXPECT_SAYS(refused("a.csv", "x,y,z,radius\n0,0,0,1\n0,0,1,0\n"), "a.csv:3: the radius 0 is not positive");
  EXPECT_SAYS(refused("a.csv", "x,y,z\n0,0,0\n"), "holds 1 points of a centreline");
  EXPECT_SAYS(refused("a.csv", "x,y,z\n0,0,0\n0,0,0\n"), "two neighbours in one place: points 1 and 2");
  EXPECT_SAYS(refused("a.vtp", "no XML"), "a.vtp");
  EXPECT_THROW(readCentreline(folder / "none.csv", 1e-3), std::runtime_error);
}

TEST_F(VesselAxis, OfABentTubeIsFoundBySections) {
  VesselParameters v;
  v.length = arcLength;
  const Centreline arc = Centreline::arc(bend, 0, arcLength);
  const TriSurface bent = bentAlong(arc, cylinderSurface(v, {60e-6, 60e-6}));
  const Centreline axis = axisBySections(bent);
  EXPECT_NEAR(axis.length() / arcLength, 1, 2e-3);
  EXPECT_NEAR(axis.largestCurvature() * bend, 1, 0.2);
  const TriSurface straight = straightened(bent, axis);
  EXPECT_NO_THROW(requireLumen(straight));
  for (std::size_t t = 0; t < straight.triangles.size(); ++t) {
    if (straight.region[t] != SurfaceRegion::wall) continue;
    for (const auto vertex : straight.triangles[t])
      EXPECT_NEAR(straight.vertices[vertex].head<2>().norm() / 0.9e-3, 1, 0.01);
  }
}

}  // namespace
}  // namespace restenosis
