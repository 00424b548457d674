#include <gtest/gtest.h>

#include "bridge/flow/RegionalFaces.h"

namespace restenosis {
namespace {

TEST(RegionalFaces, ARegionsNearestFacesAreItsOwn) {
  const std::vector<WallFace> faces = {{{0, 0, 0}, 1, {1, 0, 0}, SurfaceRegion::strut},
                                       {{0, 0, 3}, 1, {2, 0, 0}, SurfaceRegion::wall},
                                       {{0, 0, 2}, 1, {3, 0, 0}, SurfaceRegion::wall},
                                       {{0, 0, -9}, 1, {4, 0, 0}, SurfaceRegion::strut}};
  const RegionalFaces regional(faces);
  const auto wall = regional.nearest(Vec3(0, 0, 0.5), SurfaceRegion::wall, 5);
  ASSERT_EQ(wall.size(), 2u);
  EXPECT_EQ(wall[0].face, &faces[2]);
  EXPECT_DOUBLE_EQ(wall[0].distance, 1.5);
  EXPECT_EQ(wall[1].face, &faces[1]);
  const auto strut = regional.nearest(Vec3(0, 0, 2), SurfaceRegion::strut, 1);
  ASSERT_EQ(strut.size(), 1u);
  EXPECT_EQ(strut[0].face, &faces[0]);
}

TEST(RegionalFaces, AFlowWithoutStrutsHasNoneToGive) {
  const std::vector<WallFace> faces = {{{0, 0, 0}, 1, {1, 0, 0}, SurfaceRegion::wall}};
  const RegionalFaces regional(faces);
  EXPECT_TRUE(regional.nearest(Vec3::Zero(), SurfaceRegion::strut, 4).empty());
  EXPECT_EQ(regional.nearest(Vec3::Zero(), SurfaceRegion::wall, 4).size(), 1u);
}

}  // namespace
}  // namespace restenosis
