#include <gtest/gtest.h>

#include "AnalyticBackend.h"
#include "Constants.h"
#include "FlowSupport.h"
#include "TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(AnalyticBackend, poiseuilleInATube) {
  FlowConditions conditions = vesselConditions();
  for (const auto drive : {FlowConditions::Drive::flowRate, FlowConditions::Drive::pressureGradient}) {
    conditions.drive = drive;
    const auto solution = AnalyticBackend().solve(tube(vesselRadius, vesselLength), conditions, {});
    const auto error = stressError(solution, vesselStress(), 0, vesselLength);
    EXPECT_LT(error.maximum, 1e-9);
    EXPECT_NEAR(solution.pressureDrop / (conditions.pressureGradient * vesselLength), 1.0, 1e-9);
    for (const auto& face : solution.wall) EXPECT_GT(face.traction.z(), 0.0);
  }
}

TEST(AnalyticBackend, narrowingHasTheOppositeEffectUnderTheTwoDrives) {
  const auto narrowed = revolve({{0.9e-3, 0}, {0.9e-3, 0.4e-3}, {0.45e-3, 0.5e-3}, {0.45e-3, 1e-3}});
  FlowConditions conditions = vesselConditions();
  const auto fixedFlow = AnalyticBackend().solve(narrowed, conditions, {});
  EXPECT_NEAR(stressError(fixedFlow, 8.0 * vesselStress(), 0.6e-3, 0.9e-3).mean, 0.0, 1e-9);
  conditions.drive = FlowConditions::Drive::pressureGradient;
  const auto fixedGradient = AnalyticBackend().solve(narrowed, conditions, {});
  EXPECT_NEAR(stressError(fixedGradient, 0.5 * vesselStress(), 0.6e-3, 0.9e-3).mean, 0.0, 1e-9);
}

TEST(AnalyticBackend, strutsKeepTheirRegionAndAcrossFacesCarryNothing) {
  const auto solution =
      AnalyticBackend().solve(stentedTube(vesselRadius, vesselLength, 90e-6), vesselConditions(), {});
  std::size_t struts = 0, across = 0;
  for (const auto& face : solution.wall) {
    if (face.region != SurfaceRegion::strut) continue;
    ++struts;
    across += face.traction.norm() == 0.0;
  }
  EXPECT_EQ(struts, 3u * 256u);
  EXPECT_EQ(across, 2u * 256u);
}

TEST(AnalyticBackend, badSurfaceIsAFailedFlow) {
  auto lumen = tube(vesselRadius, vesselLength);
  lumen.triangles.pop_back(), lumen.region.pop_back();
  EXPECT_THROW(AnalyticBackend().solve(lumen, vesselConditions(), {}), FlowFailed);
}

}  // namespace
}  // namespace restenosis
