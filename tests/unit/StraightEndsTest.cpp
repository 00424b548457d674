#include <gtest/gtest.h>

#include "AnalyticBackend.h"
#include "Constants.h"
#include "FlowSupport.h"
#include "LumenFrame.h"
#include "LumenShape.h"
#include "StraightEnds.h"
#include "SweptTube.h"
#include "TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double ends = 0.5e-3;

TEST(StraightEnds, aTubeBecomesALongerTube) {
  const TriSurface longer = withStraightEnds(tube(vesselRadius, vesselLength), ends);
  EXPECT_NO_THROW(requireLumen(longer));
  EXPECT_NEAR(enclosedVolume(longer) / enclosedVolume(tube(vesselRadius, vesselLength + 2 * ends)), 1.0,
              1e-12);
  EXPECT_NEAR(lumenEnd(longer, SurfaceRegion::inlet).z, -ends, 1e-15);
  EXPECT_NEAR(lumenEnd(longer, SurfaceRegion::outlet).z, vesselLength + ends, 1e-15);
}

TEST(StraightEnds, followTheDirectionOfEachEnd) {
  const TriSurface bent =
      moved(bentTube(0.5e-3, 0.6e-3, 1e-3, 0.4e-3), motionTo(Vec3(1, 2, 3), Vec3(1e-3, 2e-3, -3e-3)));
  const TriSurface longer = withStraightEnds(bent, ends);
  EXPECT_NO_THROW(requireLumenWithPlanarEnds(longer));
  for (const auto region : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
    const EndPlane before = endPlane(bent, region), after = endPlane(longer, region);
    EXPECT_LT((after.centre - before.centre - ends * before.normal).norm(), 1e-12);
    EXPECT_NEAR(after.normal.dot(before.normal), 1.0, 1e-12);
    EXPECT_NEAR(after.area / before.area, 1.0, 1e-12);
  }
  const double section = endPlane(bent, SurfaceRegion::inlet).area;
  EXPECT_NEAR((enclosedVolume(longer) - enclosedVolume(bent)) / (2 * ends * section), 1.0, 1e-9);
}

TEST(StraightEnds, theWallOfTheSolutionIsTheLumens) {
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const FlowSolution plain = AnalyticBackend().solve(lumen, vesselConditions(), {});
  StraightEnds backend(std::make_unique<AnalyticBackend>(), ends);
  const FlowSolution longer = backend.solve(lumen, vesselConditions(), {});
  ASSERT_EQ(longer.wall.size(), plain.wall.size());
  for (std::size_t i = 0; i < plain.wall.size(); ++i)
    EXPECT_LT((longer.wall[i].centre - plain.wall[i].centre).norm(), 1e-12);
  EXPECT_GT(longer.pressureDrop, plain.pressureDrop);
}

TEST(StraightEnds, refuseLengthsAndSurfacesThatHaveNone) {
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  EXPECT_THROW(withStraightEnds(lumen, 0.0), std::invalid_argument);
  EXPECT_THROW(withStraightEnds(lumen, -1e-3), std::invalid_argument);
  TriSurface open = lumen;
  open.triangles.erase(open.triangles.begin());
  open.region.erase(open.region.begin());
  EXPECT_THROW(withStraightEnds(open, ends), std::invalid_argument);
  StraightEnds backend(std::make_unique<AnalyticBackend>(), ends);
  EXPECT_THROW(backend.solve(open, vesselConditions(), {}), FlowFailed);
}

}  // namespace
}  // namespace restenosis
