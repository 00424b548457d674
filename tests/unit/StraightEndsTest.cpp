#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/flow/analytic/AnalyticBackend.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/HookTube.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

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

/// A face at the centre of every triangle of the sides.
class FaceOfEachTriangle : public FlowBackend {
 public:
  std::string_view name() const override { return "faces"; }
  FlowSolution solve(const TriSurface& lumen, const FlowConditions&, const std::filesystem::path&) override {
    FlowSolution solution;
    for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
      if (lumen.region[t] == SurfaceRegion::wall)
        solution.wall.push_back(
            {lumen.centre(t), lumen.areaVector(t).norm(), Vec3::UnitZ(), SurfaceRegion::wall});
    return solution;
  }
};

TEST(StraightEnds, leaveTheWallOfALumenThatPassesBesideThem) {
  // Legs of 0.2 and 2 mm, 1.4 mm apart: the longer one runs along the end of the shorter one
  const TriSurface lumen = hookTube(0.5e-3, 0.2e-3, 0.7e-3, 2e-3);
  StraightEnds backend(std::make_unique<FaceOfEachTriangle>(), 1.5e-3);
  const FlowSolution solution = backend.solve(lumen, vesselConditions(), {});
  EXPECT_EQ(solution.wall.size(),
            static_cast<std::size_t>(std::ranges::count(lumen.region, SurfaceRegion::wall)));
}

TEST(StraightEnds, mayNotRunIntoTheLumenOrEachOther) {
  const TriSurface ring = openRing();
  // On either side of 1 mm, less the tube's radius
  EXPECT_NO_THROW(requireRoomForStraightEnds(ring, 0.55e-3));
  EXPECT_THROW(requireRoomForStraightEnds(ring, 0.65e-3), std::invalid_argument);
  EXPECT_NEAR(longestStraightEnds(ring, 1e-3), 0.6e-3, 0.11e-3);
  StraightEnds backend(std::make_unique<FaceOfEachTriangle>(), 3e-3);
  EXPECT_THROW(backend.solve(ring, vesselConditions(), {}), FlowFailed);
  EXPECT_NO_THROW(requireRoomForStraightEnds(hookTube(0.5e-3, 0.2e-3, 0.7e-3, 2e-3), 1.5e-3));
  EXPECT_NO_THROW(requireRoomForStraightEnds(stentedTube(vesselRadius, vesselLength, 90e-6), 5e-3));
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
