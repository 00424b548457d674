#include <gtest/gtest.h>

#include "bridge/compare/ProbeLines.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

TEST(ProbeLines, axisRunsThroughTheCentresOfATurnedTube) {
  const double angle = 0.3, length = 1e-3;
  const auto lines = probeLines(turnedTube(0.2e-3, length, angle, 64), {.axisPoints = 7});
  ASSERT_EQ(lines.axis.size(), 7u);
  for (const Vec3& p : lines.axis) {
    EXPECT_NEAR(p.x(), 0.0, 1e-9);
    EXPECT_NEAR(p.y(), p.z() * std::tan(angle), 1e-9);
  }
  EXPECT_NEAR(lines.axis.front().z(), length / 14, 1e-12);
}

TEST(ProbeLines, planesKeepOffTheWall) {
  const auto lines =
      probeLines(tube(vesselRadius, vesselLength), {.planes = 3, .acrossPlane = 40, .clearance = 0.1});
  ASSERT_EQ(lines.planes.size(), 3u);
  for (const auto& plane : lines.planes) {
    for (const Vec3& p : plane.points) EXPECT_LT(p.head<2>().norm(), 0.905 * vesselRadius);
    const double area = plane.points.size() * plane.spacing * plane.spacing;
    EXPECT_NEAR(area / (std::numbers::pi * 0.81 * vesselRadius * vesselRadius), 1.0, 0.03);
  }
}

}  // namespace
}  // namespace restenosis
