#include <gtest/gtest.h>

#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/LatticeSupport.h"
#include "tests/support/LbmCases.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

LbmSettings spaced(double dx) {
  LbmSettings settings;
  settings.dx = dx;
  return settings;
}

TEST(LbmBackend, poiseuilleAtFixedFlowRate) {
  const TemporaryFolder scratch;
  LbmBackend backend(spaced(60e-6));
  const auto s = backend.solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch.path() / "case");
  expectPoiseuille(s, {.stressMean = 0.01, .stressL2 = 0.01, .pressureDrop = 0.01, .massImbalance = 1e-3});
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "case/log.lbm"));
}

TEST(LbmBackend, poiseuilleAtFixedPressureGradient) {
  FlowConditions conditions = vesselConditions();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  LbmBackend backend(spaced(60e-6));
  const auto s = backend.solve(tube(vesselRadius, vesselLength), conditions, {});
  EXPECT_LT(std::abs(stressError(s, vesselStress(), 0.0, vesselLength).mean), 0.01);
  EXPECT_NEAR(s.pressureDrop / (conditions.pressureGradient * vesselLength), 1.0, 0.01);
}

TEST(LbmBackend, strutRaisesStressOnItsTopAndLowersItBeside) {
  LbmBackend backend(spaced(45e-6));
  const auto s = backend.solve(stentedTube(vesselRadius, vesselLength, 90e-6), vesselConditions(), {});
  EXPECT_GT(expectStrutDisturbs(s, 0.815e-3).stress, 1.3 * vesselStress());
}

/// Against an axisymmetric solution with cells of 1.25 um at the ring (docs/results/verification.md).
TEST(LbmBackend, aSquareRingFeelsTheStressOfAResolvedSolution) {
  constexpr double resolved = 2.043;  // mean over the ring [Pa]
  const auto s = LbmBackend(spaced(20e-6))
                     .solve(stentedTube(vesselRadius, vesselLength, 90e-6, 9), vesselConditions(), {});
  double sum = 0.0, area = 0.0;
  for (const WallFace& f : s.wall)
    if (f.region == SurfaceRegion::strut) sum += f.area * f.traction.norm(), area += f.area;
  EXPECT_NEAR(sum / area / resolved, 1.0, 0.06);
}

/// Relative L2 norm of the difference of two tractions on the same faces.
double tractionDifference(const FlowSolution& a, const FlowSolution& b) {
  double difference = 0.0, norm = 0.0;
  for (std::size_t f = 0; f < a.wall.size(); ++f) {
    difference += a.wall[f].area * (a.wall[f].traction - b.wall[f].traction).squaredNorm();
    norm += a.wall[f].area * a.wall[f].traction.squaredNorm();
  }
  return std::sqrt(difference / norm);
}

TEST(LbmBackend, coarseLatticesToStartFromChangeNothingButTheSteps) {
  LbmSettings direct = spaced(50e-6), viaCoarse = direct;
  direct.coarseLevels = 0;
  viaCoarse.coarseLevels = 1;
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const auto a = LbmBackend(direct).solve(lumen, vesselConditions(), {}),
             b = LbmBackend(viaCoarse).solve(lumen, vesselConditions(), {});
  EXPECT_LT(tractionDifference(a, b), 2.0 * direct.tolerance);
}

TEST(LbmBackend, theFormerFlowToStartFromChangesNothingButTheSteps) {
  const TemporaryFolder scratch;
  LbmSettings settings = spaced(50e-6);
  settings.coarseLevels = 0;
  LbmBackend(settings).solve(stentedTube(1.01 * vesselRadius, vesselLength, 90e-6), vesselConditions(),
                             scratch.path() / "former");
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const auto fromRest = LbmBackend(settings).solve(lumen, vesselConditions(), {});
  LbmBackend warm(settings);
  ASSERT_EQ(warm.filesToStartFrom(scratch.path() / "former").size(), 1);
  warm.startFrom(scratch.path() / "former");
  const auto fromFormer = warm.solve(lumen, vesselConditions(), {});
  EXPECT_LT(tractionDifference(fromRest, fromFormer), 2.0 * settings.tolerance);
  EXPECT_LT(fromFormer.iterations, fromRest.iterations);
}

TEST(LbmBackend, withoutTheFormerFlowItStartsAsEver) {
  const TemporaryFolder scratch;
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  LbmBackend backend(spaced(60e-6));
  EXPECT_THROW(backend.filesToStartFrom(scratch.path()), std::runtime_error);
  backend.startFrom(scratch.path());
  const auto s = backend.solve(lumen, vesselConditions(), scratch.path() / "case");
  EXPECT_EQ(s.iterations, LbmBackend(spaced(60e-6)).solve(lumen, vesselConditions(), {}).iterations);
}

/// A steady flow that two relaxation times settle to depends on its Reynolds number alone.
TEST(LbmBackend, theTimeStepChangesNothingButTheSteps) {
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  LbmSettings small = spaced(50e-6), large = small;
  small.latticeVelocity = 0.1;
  large.latticeVelocity = 0.3;
  small.tolerance = large.tolerance = 1e-4;
  const auto a = LbmBackend(small).solve(lumen, vesselConditions(), {}),
             b = LbmBackend(large).solve(lumen, vesselConditions(), {});
  EXPECT_LT(tractionDifference(a, b), 0.01);
  EXPECT_LT(b.iterations, 0.5 * a.iterations);
}

TEST(LbmBackend, poiseuilleInATubeTurnedFromTheLattice) {
  EXPECT_LT(turnedTubeError(17.0, 20).l2, 0.02);
  EXPECT_LT(turnedTubeError(45.0, 20).l2, 0.02);
}

TEST(LbmBackend, ellipticDuctTurnedAboutItsAxis) {
  const auto e = ellipticDuctError(36);
  EXPECT_LT(e.stress.l2, 0.02);
  EXPECT_LT(std::abs(e.stress.mean), 0.01);
  EXPECT_LT(std::abs(e.pressureDrop), 0.01);
  EXPECT_LT(e.velocity, 0.005);
}

}  // namespace
}  // namespace restenosis
