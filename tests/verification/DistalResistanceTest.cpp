#include <gtest/gtest.h>

#include <numbers>

#include "bridge/flow/DistalResistance.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

/// A tube with as much resistance behind it as it has itself passes half of what it would alone.
void expectHalf(std::unique_ptr<FlowBackend> solver) {
  const TemporaryFolder scratch;
  FlowConditions conditions = vesselConditions();
  const double own = conditions.pressureGradient * vesselLength / conditions.flowRate;
  conditions.distal =
      DistalBed{.resistance = own, .pressure = 2 * conditions.pressureGradient * vesselLength};
  conditions.flowRate *= 2;
  const auto s = DistalResistance(std::move(solver))
                     .solve(tube(vesselRadius, vesselLength), conditions, scratch.path() / "case");
  EXPECT_NEAR(s.flowRate / vesselConditions().flowRate, 1, 0.015);
  EXPECT_NEAR((s.flowRate * own + s.pressureDrop) / conditions.distal->pressure, 1, 0.005);
  EXPECT_LT(std::abs(stressError(s, vesselStress(), endMargin, vesselLength - endMargin).mean), 0.03);
}

TEST(DistalResistance, HalvesTheFlowOfOpenFoam) {
  RESTENOSIS_NEEDS_OPENFOAM();
  expectHalf(std::make_unique<FoamBackend>(FoamSettings::forFidelity("draft")));
}

TEST(DistalResistance, HalvesTheFlowOfTheLattice) {
  LbmSettings settings;
  settings.dx = 60e-6;
  expectHalf(std::make_unique<LbmBackend>(settings));
}

}  // namespace
}  // namespace restenosis
