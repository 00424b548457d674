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

FoamSettings withOGrid() {
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.mesh = "oGrid";
  return settings;
}

/// A snapped mesh is off by 1 % in L2.
TEST(FoamOGrid, poiseuilleAndAgainFromTheFormerFlow) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamBackend backend(withOGrid());
  const auto first = backend.solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch / "first");
  expectPoiseuille(first, {.stressMean = 0.003,
                           .stressL2 = 0.005,
                           .pressureDrop = 0.02,
                           .massImbalance = 1e-4,
                           .endMargin = endMargin});
  EXPECT_TRUE(first.remeshedBecause.empty()) << first.remeshedBecause;
  backend.startFrom(scratch / "first");
  const auto again =
      backend.solve(tube(0.99 * vesselRadius, vesselLength), vesselConditions(), scratch / "again");
  EXPECT_LT(again.iterations, first.iterations);
}

TEST(FoamOGrid, strutsInViewAreMeshedBySnappyHexMesh) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamSettings settings = withOGrid();
  settings.cellSize = 150e-6;
  FoamBackend backend(settings);
  const auto s =
      backend.solve(stentedTube(vesselRadius, vesselLength, 90e-6), vesselConditions(), scratch / "case");
  EXPECT_EQ(s.remeshedBecause, "struts are in view");
  EXPECT_TRUE(std::ranges::any_of(s.wall, [](const auto& f) { return f.region == SurfaceRegion::strut; }));
}

}  // namespace
}  // namespace restenosis
