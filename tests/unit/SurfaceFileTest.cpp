#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceFile.h"
#include "tests/support/Constants.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

std::string objText(const TriSurface& s) {
  std::string text = "# a tube\no tube\n";
  for (const Vec3& v : s.vertices)
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", 1e3 * v.x(), 1e3 * v.y(), 1e3 * v.z());
  for (const auto& t : s.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string plyText(const TriSurface& s) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      s.vertices.size(), s.triangles.size());
  for (const Vec3& v : s.vertices)
    text += fmt::format("{:.9g} {:.9g} {:.9g}\n", 1e3 * v.x(), 1e3 * v.y(), 1e3 * v.z());
  for (const auto& t : s.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

/// `regions`: an array of the cells, or empty.
std::string vtpText(const TriSurface& s, const std::string& regions = "") {
  std::string points, corners, ends;
  for (const Vec3& v : s.vertices)
    points += fmt::format("{:.9g} {:.9g} {:.9g} ", 1e3 * v.x(), 1e3 * v.y(), 1e3 * v.z());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    corners += fmt::format("{} {} {} ", s.triangles[t][0], s.triangles[t][1], s.triangles[t][2]);
    ends += fmt::format("{} ", 3 * t + 3);
  }
  return fmt::format(
      R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{}">
<CellData>{}</CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray></Polys>
</Piece></PolyData></VTKFile>
)",
      s.vertices.size(), s.triangles.size(), regions, points, corners, ends);
}

std::string regionNumbers(const TriSurface& s) {
  std::string numbers;
  for (const SurfaceRegion region : s.region) numbers += fmt::format("{} ", static_cast<int>(region));
  return fmt::format(R"(<DataArray type="UInt8" Name="region" format="ascii">{}</DataArray>)", numbers);
}

/// As VTK writes texts in ASCII: the bytes' numbers, each text with a 0 behind it.
std::string regionTexts(const TriSurface& s) {
  std::string bytes;
  for (const SurfaceRegion region : s.region) {
    for (const char c : regionName(region)) bytes += fmt::format("{} ", static_cast<int>(c));
    bytes += "0 ";
  }
  return fmt::format(R"(<Array type="String" Name="region" format="ascii" NumberOfTuples="{}">{}</Array>)",
                     s.region.size(), bytes);
}

struct SurfaceFile : ::testing::Test {
  TemporaryFolder folder;
  const TriSurface ringed = revolve({{vesselRadius, 0},
                                     {vesselRadius, 0.4 * vesselLength, SurfaceRegion::strut},
                                     {vesselRadius, 0.6 * vesselLength},
                                     {vesselRadius, vesselLength}});

  std::filesystem::path written(const std::string& name, const std::string& text) const {
    writeText(folder / name, text);
    return folder / name;
  }
  void expectRefused(const std::string& name, const std::string& text, std::string_view says) const {
    written(name, text);
    expectRefused(name, says);
  }
  void expectRefused(const std::string& name, std::string_view says) const {
    SCOPED_TRACE(name);
    try {
      readSurfaceTriangles(folder / name);
      ADD_FAILURE() << "accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_SAYS(std::string_view(error.what()), says);
    }
  }
};

std::size_t strutsIn(const TriSurface& s) {
  return static_cast<std::size_t>(std::ranges::count(s.region, SurfaceRegion::strut));
}

TEST_F(SurfaceFile, EveryFormatIsTheSameLumen) {
  const TriSurface plain = tube(vesselRadius, vesselLength);
  writeStl(folder / "tube.stl", plain, 1e-3);
  const TriSurface stl = loadLumen(folder / "tube.stl", 1e-3);
  for (const auto& [name, text] : std::map<std::string, std::string>{
           {"tube.obj", objText(plain)}, {"tube.PLY", plyText(plain)}, {"tube.vtp", vtpText(plain)}}) {
    SCOPED_TRACE(name);
    const TriSurface lumen = loadLumen(written(name, text), 1e-3);
    EXPECT_EQ(lumen.triangles.size(), stl.triangles.size());
    for (const SurfaceRegion end : {SurfaceRegion::inlet, SurfaceRegion::outlet})
      EXPECT_NEAR(endDiameter(lumen, end), endDiameter(stl, end), 1e-6 * vesselRadius);
  }
}

TEST_F(SurfaceFile, RegionsOfCellsNameTheParts) {
  for (const auto& regions : {regionNumbers(ringed), regionTexts(ringed)}) {
    const TriSurface lumen = loadLumen(written("ringed.vtp", vtpText(ringed, regions)), 1e-3);
    EXPECT_EQ(strutsIn(lumen), strutsIn(ringed));
    EXPECT_GT(strutsIn(lumen), 0U);
  }
  EXPECT_EQ(strutsIn(loadLumen(written("plain.vtp", vtpText(ringed)), 1e-3)), 0U);
}

TEST_F(SurfaceFile, PolygonsAreDividedIntoTriangles) {
  const FileTriangles read =
      readSurfaceTriangles(written("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
  EXPECT_EQ(read.corners.size(), 2U);
  EXPECT_EQ(read.solid.size(), 2U);
}

TEST_F(SurfaceFile, WhatIsNoneIsNamed) {
  for (const char* name : {"x.vtp", "x.ply", "x.obj"}) {
    expectRefused(name, "", name);
    expectRefused(name, "this is no surface\n", name);
    expectRefused(std::string("none/") + name, "does not exist");
  }
  expectRefused("x.vtp", vtpText(ringed).substr(0, 4000), "x.vtp");
  std::string numbers = regionNumbers(ringed);
  numbers.replace(numbers.find(">0 ") + 1, 1, "7");
  expectRefused("x.vtp", vtpText(ringed, numbers), "'region'");
}

TEST_F(SurfaceFile, AFaceWithoutItsVerticesIsRefused) {
  const TriSurface plain = tube(vesselRadius, vesselLength);
  TriSurface astray = plain;
  astray.triangles[5][1] = 1U << 20;
  expectRefused("x.vtp", vtpText(astray), "names no vertex");
  expectRefused("x.ply", plyText(astray), "x.ply");
  expectRefused("x.obj", objText(astray), "x.obj");
  TriSurface endless = plain;
  endless.vertices[7].x() = std::numeric_limits<double>::infinity();
  expectRefused("x.vtp", vtpText(endless), "x.vtp");
}

TEST(SurfaceFileName, DecidesTheFormat) {
  EXPECT_TRUE(isSurfaceFile("a/b.STL"));
  EXPECT_TRUE(isSurfaceFile("b.Vtp"));
  EXPECT_FALSE(isSurfaceFile("b.csv"));
  EXPECT_FALSE(isSurfaceFile("stl"));
}

}  // namespace
}  // namespace restenosis
