#include <gtest/gtest.h>

#include "bridge/surface/LoadedStruts.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/StrutSolids.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

using namespace support;

class LoadedStruts : public testing::Test {
 protected:
  TriSurface load(const TriSurface& surface) const {
    writeStl(file, surface, 1e-3);
    return loadStruts(file, 1e-3);
  }
  std::string refusal(const TriSurface& surface) const {
    try {
      load(surface);
      return "accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(file.string())) << error.what();
      return error.what();
    }
  }
  TemporaryFolder folder;
  std::filesystem::path file = folder / "struts.stl";
  const TriSurface one = box(Vec3::Zero(), {1e-4, 1e-4, 3e-4});
  const TriSurface other = box({0, 0, 5e-4}, {1e-4, 1e-4, 6e-4});
};

#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(LoadedStruts, NormalsAreTurnedOutwardsPieceByPiece) {
  for (const TriSurface& surface : {together(one, other), together(insideOut(one), other),
                                    together(one, insideOut(other)), insideOut(together(one, other))}) {
    const TriSurface loaded = load(surface);
    EXPECT_NEAR(enclosedVolume(loaded), 4e-12, 1e-17);
    EXPECT_EQ(loaded.triangles.size(), 24u);
  }
}

TEST_F(LoadedStruts, SingleTrianglesMayBeTurnedOver) {
  TriSurface mixed = one;
  std::swap(mixed.triangles[3][0], mixed.triangles[3][1]);
  EXPECT_NEAR(enclosedVolume(load(mixed)), 3e-12, 1e-17);
}

TEST_F(LoadedStruts, HolesOverlapsAndFlatPiecesAreRefused) {
  TriSurface hole = one;
  hole.triangles.pop_back(), hole.region.pop_back();
  EXPECT_HAS(refusal(hole), "is not closed: 3 edges have only one triangle, one of 0.");
  EXPECT_HAS(refusal(together(one, box({1e-4, 0, 0}, {2e-4, 1e-4, 3e-4}))), "more than two triangles");
  TriSurface flat = other;
  for (Vec3& v : flat.vertices) v.x() = 2e-4;
  EXPECT_NE(refusal(together(one, flat)), "accepted");
}

TEST_F(LoadedStruts, PiecesMayOverlapButNonePassesThroughItself) {
  const TriSurface overlapping = box({0.5e-4, 0.2e-4, 1e-4}, {3e-4, 0.8e-4, 2e-4});
  EXPECT_NEAR(enclosedVolume(load(together(one, overlapping))), 4.5e-12, 1e-17);
  TriSurface pierced = one;
  pierced.vertices[7] = {0.6e-4, 0.4e-4, -1e-4};  // a corner of the upper end, pushed out of the lower one
  EXPECT_HAS(refusal(pierced), "a piece of the struts' surface passes through itself, at (");
}

TEST_F(LoadedStruts, FilesThatWereJoinedAreAllRead) {
  writeStl(file, one, 1e-3);
  const std::string first = readText(file);
  writeStl(file, other, 1e-3);
  writeText(file, first + readText(file));
  EXPECT_NEAR(enclosedVolume(loadStruts(file, 1e-3)), 4e-12, 1e-17);
}

TEST_F(LoadedStruts, FilesThatAreNoSurfacesAreNamed) {
  writeText(file, "x,y,z,radius\n1,2,3,4\n");
  EXPECT_THROW(loadStruts(file, 1e-3), std::runtime_error);
  EXPECT_THROW(loadStruts(folder / "absent.stl", 1e-3), std::runtime_error);
}

}  // namespace
}  // namespace restenosis
