#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

/// A tube whose outlet is cut in halves that take half of the flow each: Poiseuille's solution, everywhere.
TEST(BranchingFlow, ThroughHalvesOfAnOutletIsThatOfATube) {
  RESTENOSIS_NEEDS_OPENFOAM();
  TriSurface lumen = tube(vesselRadius, vesselLength);
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::outlet && lumen.centre(t).x() < 0)
      lumen.region[t] = outletRegion(1);
  FlowConditions conditions = vesselConditions();
  conditions.outlets = {{.name = "right", .share = 0.5}, {.name = "left", .share = 0.5}};
  const TemporaryFolder scratch;
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const FlowSolution s = backend.solve(lumen, conditions, scratch / "case");
  ASSERT_EQ(s.outlets.size(), 2U);
  EXPECT_NEAR(s.outlets[1].flowRate / conditions.flowRate, 0.5, 1e-3);
  EXPECT_LT(s.massImbalance, 1e-3);
  const double drop = conditions.pressureGradient * vesselLength;
  EXPECT_NEAR(s.outlets[1].pressure / drop, 0, 0.02);
  EXPECT_NEAR(s.pressureDrop / drop, 1, 0.03);
  // Where the outlet is cut its velocity is disturbed
  const StressError error = stressError(s, vesselStress(), endMargin, vesselLength - vesselRadius / 3);
  RecordProperty("mean", std::to_string(error.mean));
  RecordProperty("l2", std::to_string(error.l2));
  EXPECT_LT(std::abs(error.mean), 0.02);
  EXPECT_LT(error.l2, 0.02);
}

}  // namespace
}  // namespace restenosis
