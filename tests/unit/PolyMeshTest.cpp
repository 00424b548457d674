#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/Constants.h"
#include "tests/support/PolyMeshFiles.h"
#include "tests/support/TubeMesh.h"

namespace restenosis {
namespace {

using namespace support;

TEST(PolyMesh, isReadAsItWasWritten) {
  const TemporaryFolder scratch;
  const PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 12, 3, 4);
  writePolyMesh(mesh, scratch.path());
  const PolyMesh read = readPolyMesh(scratch.path());
  EXPECT_EQ(read.points, mesh.points);
  EXPECT_EQ(read.faceStart, mesh.faceStart);
  EXPECT_EQ(read.faceCorners, mesh.faceCorners);
  EXPECT_EQ(read.owner, mesh.owner);
  EXPECT_EQ(read.neighbour, mesh.neighbour);
  EXPECT_EQ(read.cells(), 12u * 3 * 4);
  ASSERT_NE(read.patch("wall"), nullptr);
  EXPECT_EQ(read.patch("wall")->faces, 12u * 4);
  EXPECT_EQ(read.patch("strut"), nullptr);
}

TEST(PolyMesh, theLastCellMayOwnNoFace) {
  PolyMesh mesh;
  mesh.owner = {0, 1, 0}, mesh.neighbour = {2};
  EXPECT_EQ(mesh.cells(), 3u);
}

TEST(PolyMesh, cellCentresLieInTheirCells) {
  const PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 12, 3, 4);
  const auto centres = mesh.cellCentres();
  for (std::size_t c = 0; c < centres.size(); ++c) {
    const int layer = static_cast<int>(c) / (3 * 12), ring = static_cast<int>(c) / 12 % 3;
    EXPECT_NEAR(centres[c].z(), 0.3e-3 * (layer + 0.5), 1e-15);
    const double r = std::hypot(centres[c].x(), centres[c].y());
    EXPECT_GT(r, 0.3e-3 * ring);
    EXPECT_LT(r, 0.32e-3 * (ring + 1));
  }
}

TEST(PolyMesh, aCopyHasTheNewPoints) {
  const TemporaryFolder scratch;
  const PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 8, 2, 2);
  writePolyMesh(mesh, scratch / "from");
  std::vector<Vec3> points = mesh.points;
  for (Vec3& p : points) p *= 0.5;
  copyPolyMesh(scratch / "from", scratch / "to", points);
  const PolyMesh copy = readPolyMesh(scratch / "to");
  EXPECT_EQ(copy.points, points);
  EXPECT_EQ(copy.faceCorners, mesh.faceCorners);
}

TEST(PolyMesh, whatDoesNotFitIsRefused) {
  const PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 8, 2, 2);
  const auto expectRefused = [&](const char* file, auto spoil) {
    SCOPED_TRACE(file);
    const TemporaryFolder scratch;
    writePolyMesh(mesh, scratch.path());
    const auto path = scratch.path() / "constant/polyMesh" / file;
    writeText(path, spoil(readText(path)));
    EXPECT_THROW(readPolyMesh(scratch.path()), std::runtime_error);
  };
  const auto cutOff = [](const std::string& text) { return text.substr(0, text.size() / 2); };
  for (const char* file : {"points", "faces", "owner", "neighbour"}) expectRefused(file, cutOff);
  expectRefused("points", [](std::string text) { return text.replace(text.find("binary"), 6, "ascii"); });
  expectRefused("points", [](std::string text) { return text.replace(text.find("=32"), 3, "=64"); });
  expectRefused("points", [](const std::string&) { return std::string(); });
  expectRefused("points", [](const std::string&) {
    return foamHeader("vectorField") + foamBinaryList({0, 0, 0, 1, 0, 0}, 3);
  });
  expectRefused("owner", [&](const std::string&) {
    auto owner = mesh.owner;
    owner.pop_back();
    return foamHeader("labelList") + binaryLabels(owner);
  });
  expectRefused("neighbour", [&](const std::string&) {
    auto neighbour = mesh.neighbour;
    neighbour[0] = -1;
    return foamHeader("labelList") + binaryLabels(neighbour);
  });
}

}  // namespace
}  // namespace restenosis
