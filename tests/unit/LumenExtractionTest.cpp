#include <gtest/gtest.h>

#include "bridge/coupling/LumenExtraction.h"

namespace restenosis {
namespace {

struct LumenExtractionTest : ::testing::Test {
  Scene scene;
  Wall wall = emptyWall(scene.vessel);
  std::optional<Stent> stent;
  PartTimer timer;
  LumenExtraction extraction{scene, wall, stent, timer};
  LumenState lumen;
};

TEST_F(LumenExtractionTest, withoutTissueTheLumenIsTheVesselsShape) {
  extraction.extract(lumen);
  const double radius = scene.vessel.lumenDiameter / 2;
  EXPECT_NEAR(lumen.present.radiusAt({1e-4, 0, scene.vessel.length / 2}), radius, 1e-9);
  EXPECT_FALSE(lumen.closed);
  EXPECT_FALSE(extraction.surface().triangles.empty());
}

TEST_F(LumenExtractionTest, theFirstShapeIsThatAfterDeployment) {
  extraction.extract(lumen);
  scene.vessel.stenosis = 0.5;
  extraction.extract(lumen);
  const Vec3 throat(1e-4, 0, scene.vessel.length / 2);
  EXPECT_LT(lumen.present.radiusAt(throat), 0.9 * lumen.afterDeployment.radiusAt(throat));
}

TEST_F(LumenExtractionTest, theSurfaceIsKeptUntilItIsReleased) {
  const auto corners = [&] {
    const TriSurface& surface = extraction.surface();
    return std::vector<Vec3>(surface.vertices);
  };
  const auto tube = corners();
  scene.vessel.lumenDiameter *= 1.1;
  EXPECT_EQ(corners(), tube);
  extraction.release();
  EXPECT_NE(corners(), tube);
}

}  // namespace
}  // namespace restenosis
