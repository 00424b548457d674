#include <gtest/gtest.h>

#include "bridge/scene/FlowResolution.h"

namespace restenosis {
namespace {

/// A lumen of a file, to be solved in at `draft`: cells of 90 um, nodes 25 um apart.
Scene loadedScene(const char* backend) {
  Scene scene;
  scene.scene.fidelity = "draft";
  scene.vessel.lumenSurface = "lumen.stl";
  scene.vessel.lumenDiameter = 1.8e-3;
  scene.flow.emplace().backend = backend;
  return scene;
}

TEST(FlowResolution, OfALoadedLumenIsThatOfItsOwnExtent) {
  const Units units;
  const Scene foam = loadedScene("foam"), lbm = loadedScene("lbm");
  EXPECT_FALSE(resolutionProblem(foam, units));  // nothing is known of it
  EXPECT_FALSE(resolutionProblem(foam, units, LoadedExtent{1.8e-3, 4.5e-3, 1.1e-8}));

  const LoadedExtent narrow{0.15e-3, 1e-3, 1.8e-11};
  const auto tooNarrow = resolutionProblem(foam, units, narrow);
  ASSERT_TRUE(tooNarrow);
  EXPECT_EQ(tooNarrow->key, "scene.fidelity");
  EXPECT_EQ(tooNarrow->message,
            "'cellSize' in [foam] is 90 um: a lumen of 0.15 mm has 1.7 cells across, at least 8 are needed");
  ASSERT_TRUE(resolutionProblem(lbm, units, narrow));
  EXPECT_EQ(resolutionProblem(lbm, units, narrow)->message,
            "'dx' in [lbm] is 25 um: a lumen of 0.15 mm has 6 nodes across, at least 8 are needed");

  const LoadedExtent shorter{1.8e-3, 0.02e-3, 5e-11};
  ASSERT_TRUE(resolutionProblem(foam, units, shorter));
  EXPECT_EQ(resolutionProblem(foam, units, shorter)->key, "vessel.lumenSurface");

  const LoadedExtent large{20e-3, 100e-3, 3.1e-5};
  ASSERT_TRUE(resolutionProblem(foam, units, large));
  EXPECT_EQ(resolutionProblem(foam, units, large)->message,
            "'cellSize' in [foam] is 90 um: a lumen of 20 mm and 100 mm length takes at least 4.3e+07 cells, "
            "more than 'maximumCells' = 6e+06");
}

}  // namespace
}  // namespace restenosis
