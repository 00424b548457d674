#include <gtest/gtest.h>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/analytic/AnalyticBackend.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenFrame, StraightTubesAreLaidAlongZ) {
  const auto motion = motionTo(Vec3(1, 2, 3), Vec3(1e-3, 0, -4e-3));
  const TriSurface oblique = moved(tube(vesselRadius, vesselLength), motion);
  EXPECT_FALSE(liesAlongZ(oblique));
  const auto frame = frameAlongZ(oblique);
  ASSERT_TRUE(frame);
  const TriSurface laid = movedAlongZ(oblique, *frame);
  EXPECT_NO_THROW(requireLumen(laid));
  EXPECT_TRUE(liesAlongZ(laid));
  EXPECT_NEAR(lumenEnd(laid, SurfaceRegion::inlet).z, 0.0, 1e-15);
  EXPECT_NEAR(lumenEnd(laid, SurfaceRegion::outlet).z, vesselLength, 1e-12);
}

TEST(LumenFrame, ALumenAlongZIsOnlyShifted) {
  const auto frame = frameAlongZ(tube(vesselRadius, vesselLength));
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->linear().isIdentity(1e-12));
  EXPECT_NEAR(frame->translation().norm(), 0.0, 1e-12);
}

TEST(LumenFrame, BentTubesHaveNone) {
  EXPECT_FALSE(frameAlongZ(bentTube(vesselRadius, 1e-3, 2e-3, 1e-3)));
  // Parallel ends, but the arc between them lies beyond both
  std::vector<AxisPoint> axis;
  for (int i = 0; i <= 24; ++i) {
    const double turn = std::numbers::pi * i / 24;
    axis.push_back(
        {2e-3 * Vec3(1 - std::cos(turn), 0, std::sin(turn)), Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  EXPECT_FALSE(frameAlongZ(sweptTube(axis, vesselRadius)));
}

TEST(AnyDirection, SolutionsAreThoseOfTheTubeAlongZ) {
  const auto motion = motionTo(Vec3(1, 2, 3), Vec3(1e-3, 0, -4e-3));
  const TriSurface oblique = moved(tube(vesselRadius, vesselLength), motion);
  AnyDirection backend(std::make_unique<AnalyticBackend>());
  const FlowSolution s = backend.solve(oblique, vesselConditions(), {});
  ASSERT_FALSE(s.wall.empty());
  const Vec3 axis = motion.linear() * Vec3::UnitZ();
  for (const WallFace& f : s.wall) {
    EXPECT_NEAR((motion.inverse() * f.centre).head<2>().norm() / vesselRadius, 1.0, 0.01);
    EXPECT_NEAR(f.traction.dot(axis) / vesselStress(), 1.0, 0.01);
  }
  EXPECT_THROW(backend.solve(bentTube(vesselRadius, 1e-3, 2e-3, 1e-3), vesselConditions(), {}), FlowFailed);
}

}  // namespace
}  // namespace restenosis
