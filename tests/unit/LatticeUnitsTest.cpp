#include <gtest/gtest.h>

#include "bridge/flow/lbm/LatticeUnits.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(FlowEstimate, isPoiseuillesInATube) {
  const FlowEstimate e(tube(vesselRadius, vesselLength), vesselConditions());
  EXPECT_NEAR(e.peakVelocity() / (2.0 * meanVelocity), 1.0, 1e-6);
  EXPECT_NEAR(e.velocity(Vec3(0, 0, 0.5e-3)), 2.0 * meanVelocity, 1e-6);
  EXPECT_EQ(e.velocity(Vec3(2.0 * vesselRadius, 0, 0.5e-3)), 0.0);
  const double drop = vesselConditions().pressureGradient * vesselLength;
  EXPECT_NEAR(e.pressure(Vec3::Zero()) / drop, 1.0, 0.01);
}

TEST(FlowEstimate, findsTheFlowRateOfAPressureGradient) {
  FlowConditions conditions = vesselConditions();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  const FlowEstimate e(tube(vesselRadius, vesselLength), conditions);
  EXPECT_NEAR(e.flowRate() / vesselConditions().flowRate, 1.0, 1e-6);
}

TEST(LatticeUnits, stepFollowsTheVelocityOrTheViscosity) {
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  const FlowConditions fast = vesselConditions();
  const FlowEstimate estimate(lumen, fast);
  const LatticeUnits byVelocity = latticeUnits(20e-6, estimate, fast, 0.1);
  EXPECT_NEAR(estimate.peakVelocity() / byVelocity.velocity(), 0.1, 1e-9);

  FlowConditions slow = fast;
  slow.flowRate *= 1e-4;
  const LatticeUnits byViscosity = latticeUnits(20e-6, FlowEstimate(lumen, slow), slow, 0.1);
  EXPECT_NEAR(byViscosity.relaxationTime(slow.kinematicViscosity), 2.0, 1e-9);
}

}  // namespace
}  // namespace restenosis
