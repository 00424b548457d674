#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceCheck.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

struct StlFile : testing::Test {
  std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("restenosisFoam-stl-" + std::to_string(getpid()) + ".stl");
  VesselParameters vessel;
  TriSurface surface;
  StlFile() {
    vessel.length = 1e-3;
    surface = cylinderSurface(vessel, {100e-6, 100e-6});
  }
  ~StlFile() override { std::filesystem::remove(file); }

  void expectRoundTrip() {
    TriSurface read = readStl(file, 1e-3);
    markEnds(read, vessel.length, 1e-9);
    const SurfaceReport report = checkSurface(read, vessel.length),
                        original = checkSurface(surface, vessel.length);
    EXPECT_TRUE(report.good()) << report.summary();
    EXPECT_EQ(read.triangles.size(), surface.triangles.size());
    EXPECT_NEAR(report.volume, original.volume, 1e-6 * original.volume);
    EXPECT_NEAR(report.areaOf(SurfaceRegion::inlet), original.areaOf(SurfaceRegion::inlet), 1e-12);
  }
};

TEST_F(StlFile, BinaryIsReadAsWritten) {
  writeStl(file, surface, 1e-3);
  EXPECT_EQ(std::filesystem::file_size(file), 84 + 50 * surface.triangles.size());
  expectRoundTrip();
}

TEST_F(StlFile, NamedSolidsAreReadAsWritten) {
  writeNamedStl(file, surface, 1e-3);
  std::ifstream in(file);
  std::string first;
  std::getline(in, first);
  EXPECT_EQ(first, "solid wall");
  in.close();
  expectRoundTrip();
}

TEST_F(StlFile, WritesChosenRegionsOnly) {
  const SurfaceRegion wall[] = {SurfaceRegion::wall, SurfaceRegion::strut};
  writeStl(file, surface, 1e-3, wall);
  const SurfaceReport report = checkSurface(readStl(file, 1e-3), vessel.length);
  EXPECT_FALSE(report.good());
  EXPECT_LT(readStl(file, 1e-3).triangles.size(), surface.triangles.size());
}

TEST_F(StlFile, NamesWhatCannotBeReadOrWritten) {
  EXPECT_THROW(readStl("/nowhere/lumen.stl", 1e-3), std::runtime_error);
  EXPECT_THROW(writeStl("/nowhere/lumen.stl", surface, 1e-3), WriteFailed);
  std::ofstream(file) << "not a surface";
  EXPECT_THROW(readStl(file, 1e-3), std::runtime_error);
}

}  // namespace
}  // namespace restenosis
