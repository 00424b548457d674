#include <gtest/gtest.h>

#include <vector>

#include "bridge/sampling/WssStatistics.h"

namespace restenosis {
namespace {

TEST(WssStatistics, WeighsByArea) {
  std::vector<WallFace> faces;
  for (int n = 1; n <= 100; ++n) faces.push_back({Vec3::Zero(), 2.0, {0, 0, n * 0.01}, SurfaceRegion::wall});
  faces.push_back({Vec3::Zero(), 5.0, {3, 0, 4}, SurfaceRegion::strut});
  const WssStatistics wall = wssStatistics(faces, SurfaceRegion::wall);
  EXPECT_DOUBLE_EQ(wall.area, 200);
  EXPECT_NEAR(wall.mean, 0.505, 1e-12);
  EXPECT_NEAR(wall.p5, 0.05, 1e-12);
  EXPECT_NEAR(wall.median, 0.50, 1e-12);
  EXPECT_NEAR(wall.p95, 0.95, 1e-12);
  EXPECT_NEAR(wall.lowAreaFraction, 0.27, 1e-12);
  EXPECT_DOUBLE_EQ(wssStatistics(faces, SurfaceRegion::strut).median, 5.0);
}

TEST(WssStatistics, WhereAllIsLowTheFractionIsExactlyOne) {
  std::vector<WallFace> faces;
  for (int n = 0; n < 1000; ++n)  // areas whose sum depends on its order, stresses that turn it round
    faces.push_back({Vec3::Zero(), 1.0 / (3 + n), {0, 0, 1e-3 * (1000 - n)}, SurfaceRegion::wall});
  EXPECT_EQ(wssStatistics(faces, SurfaceRegion::wall, 2.0).lowAreaFraction, 1.0);
}

TEST(WssStatistics, AreZeroWithoutFaces) {
  EXPECT_EQ(wssStatistics({}, SurfaceRegion::wall).mean, 0.0);
  EXPECT_EQ(wssStatistics({}, SurfaceRegion::wall).area, 0.0);
}

}  // namespace
}  // namespace restenosis
