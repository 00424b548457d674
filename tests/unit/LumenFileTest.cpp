#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/compare/LumenFile.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/output/LumenWriter.h"
#include "bridge/output/PvdSeries.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenFile, aWrittenLumenIsReadBackClosed) {
  const TemporaryFolder folder;
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  writeLumen(folder / "lumen.vtp", lumen, nullptr, 0.0);
  const TriSurface read = readLumen(folder / "lumen.vtp");
  EXPECT_NO_THROW(requireLumen(read));
  EXPECT_EQ(read.triangles.size(), lumen.triangles.size());
  EXPECT_NEAR(enclosedVolume(read) / enclosedVolume(lumen), 1.0, 1e-6);
  EXPECT_EQ(std::ranges::count(read.region, SurfaceRegion::strut),
            std::ranges::count(lumen.region, SurfaceRegion::strut));
  EXPECT_NEAR(lumenEnd(read, SurfaceRegion::inlet).z, 0.0, 1e-12);
  EXPECT_NEAR(lumenEnd(read, SurfaceRegion::outlet).z, vesselLength, 1e-9);
}

TEST(LumenFile, theInletIsTheOneWrittenEvenWhereItIsTheUpperEnd) {
  const TemporaryFolder folder;
  TriSurface lumen = tube(vesselRadius, vesselLength);
  for (SurfaceRegion& region : lumen.region) {
    if (region == SurfaceRegion::inlet)
      region = SurfaceRegion::outlet;
    else if (region == SurfaceRegion::outlet)
      region = SurfaceRegion::inlet;
  }
  writeLumen(folder / "lumen.vtp", lumen, nullptr, 0.0);
  const TriSurface read = readLumen(folder / "lumen.vtp");
  EXPECT_NEAR(lumenEnd(read, SurfaceRegion::inlet).z, vesselLength, 1e-9);
  EXPECT_NEAR(lumenEnd(read, SurfaceRegion::outlet).z, 0.0, 1e-12);
}

TEST(LumenFile, aLumenInAnyDirectionIsReadBackClosed) {
  const TemporaryFolder folder;
  TriSurface lumen = tube(vesselRadius, vesselLength);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  for (Vec3& vertex : lumen.vertices) vertex = turn * vertex + Vec3(0.01, -0.3, 0.2);
  writeLumen(folder / "lumen.vtp", lumen, nullptr, 0.0);
  const TriSurface read = readLumen(folder / "lumen.vtp");
  EXPECT_NO_THROW(requireLumenWithPlanarEnds(read));
  EXPECT_NEAR(enclosedVolume(read) / enclosedVolume(lumen), 1.0, 1e-4);
  const auto frame = frameAlongZ(read);
  ASSERT_TRUE(frame);
  EXPECT_NEAR(lumenEnd(movedAlongZ(read, *frame), SurfaceRegion::outlet).z, vesselLength, 1e-7);
}

TEST(LumenFile, theLumenOfADayIsTheNearest) {
  const TemporaryFolder folder;
  PvdSeries series(folder.path(), "lumen");
  series.begin();
  for (const int step : {0, 12, 24}) {
    writeLumen(series.dataFile(step), tube(vesselRadius, vesselLength), nullptr, 3600.0 * step);
    series.add(step, 3600.0 * step);
  }
  const auto lumens = recordedLumens(folder.path());
  ASSERT_EQ(lumens.size(), 3u);
  EXPECT_DOUBLE_EQ(lumenOfDay(lumens, 0.4).day, 0.5);
  EXPECT_DOUBLE_EQ(lumenOfDay(lumens, 99).day, 1.0);
  EXPECT_NO_THROW(readLumen(lumens.back().file));
}

TEST(LumenFile, whatIsNoLumenIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(recordedLumens(folder.path()), std::runtime_error);
  EXPECT_THROW(readLumen(folder / "lumen.vtp"), std::runtime_error);
  TriSurface holed = tube(vesselRadius, vesselLength);
  holed.triangles.erase(holed.triangles.begin() + 900);
  holed.region.erase(holed.region.begin() + 900);
  writeLumen(folder / "lumen.vtp", holed, nullptr, 0.0);
  EXPECT_THROW(readLumen(folder / "lumen.vtp"), std::runtime_error);
}

TEST(LumenFile, aDamagedIndexIsNamed) {
  const std::string file = " file=\"lumen/a.vtp\"", longName(500000, 'a');
  for (const std::string& entry : {"timestep=\"x\"" + file, "timestep=\"1e999\"" + file,
                                   std::string("timestep=\"4\""), "timestep=\"4\" " + longName}) {
    const TemporaryFolder folder;
    writeText(folder / "lumen.pvd", "<Collection>\n<DataSet " + entry + "/>\n</Collection>\n");
    try {
      recordedLumens(folder.path());
      ADD_FAILURE() << entry.substr(0, 60);
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("lumen.pvd is damaged"), std::string::npos) << error.what();
    }
  }
}

TEST(LumenFile, aFaceThatNamesNoVertexIsRefused) {
  const TemporaryFolder folder;
  for (const char* corner : {"3", "-1", "1000000"}) {
    writeText(folder / "lumen.vtp",
              fmt::format("<VTKFile type='PolyData' version='0.1' byte_order='LittleEndian'><PolyData>"
                          "<Piece NumberOfPoints='3' NumberOfPolys='1'><Points>"
                          "<DataArray type='Float64' NumberOfComponents='3' format='ascii'>"
                          "0 0 0 1 0 0 0 1 0</DataArray></Points><Polys>"
                          "<DataArray type='Int64' Name='connectivity' format='ascii'>0 1 {}</DataArray>"
                          "<DataArray type='Int64' Name='offsets' format='ascii'>3</DataArray></Polys>"
                          "<CellData><DataArray type='Float64' Name='region' format='ascii'>0</DataArray>"
                          "</CellData></Piece></PolyData></VTKFile>",
                          corner));
    try {
      readLumen(folder / "lumen.vtp");
      ADD_FAILURE() << corner;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("a face names no vertex"), std::string::npos) << error.what();
    }
  }
}

std::string refusalOf(const TriSurface& lumen) {
  const TemporaryFolder folder;
  writeLumen(folder / "lumen.vtp", lumen, nullptr, 0.0);
  try {
    readLumen(folder / "lumen.vtp");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LumenFile, saysWhatIsWrongWithALumen) {
  const TriSurface whole = tube(vesselRadius, vesselLength);
  EXPECT_EQ(refusalOf(whole), "");
  TriSurface holed = whole;
  // Two holes in one corner: rims that touch are told apart.
  for (const std::size_t t : {902u, 900u}) {
    holed.triangles.erase(holed.triangles.begin() + t);
    holed.region.erase(holed.region.begin() + t);
  }
  EXPECT_NE(refusalOf(holed).find("the lumen has a hole at ("), std::string::npos) << refusalOf(holed);
  TriSurface turned = whole;
  std::swap(turned.triangles[900][0], turned.triangles[900][1]);
  EXPECT_NE(refusalOf(turned).find("face opposite ways"), std::string::npos) << refusalOf(turned);
  TriSurface closed = whole;
  for (SurfaceRegion& region : closed.region)
    if (region == SurfaceRegion::inlet) region = SurfaceRegion::wall;
  EXPECT_NE(refusalOf(closed).find("has not two open ends"), std::string::npos) << refusalOf(closed);
}

}  // namespace
}  // namespace restenosis
