#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamBackend.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/EllipticDuct.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

TEST(FoamBackend, poiseuilleAtFixedFlowRate) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const auto s = backend.solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch.path() / "case");
  expectPoiseuille(s, {.stressMean = meanLimit,
                       .stressL2 = l2Limit,
                       .pressureDrop = 0.03,
                       .massImbalance = 1e-4,
                       .endMargin = endMargin});
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "case/case.foam"));
}

/// Tissue that has covered a strut leaves now and then a last triangle of it.
TEST(FoamBackend, aSpeckOfAStrutThatNoCellShowsIsWall) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  TriSurface lumen = tube(vesselRadius, vesselLength, 120);
  const auto middle = std::ranges::find_if(lumen.triangles, [&](const auto& t) {
    return std::abs(lumen.vertices[t[0]].z() - vesselLength / 2) < 1e-6;
  });
  const auto speck = static_cast<std::size_t>(middle - lumen.triangles.begin());
  ASSERT_LT(speck, lumen.triangles.size());
  ASSERT_EQ(lumen.region[speck], SurfaceRegion::wall);
  lumen.region[speck] = SurfaceRegion::strut;
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.strutLevel = settings.wallLevel;
  FoamBackend backend(settings);
  const auto s = backend.solve(lumen, vesselConditions(), scratch / "case");
  for (const WallFace& face : s.wall) EXPECT_EQ(face.region, SurfaceRegion::wall);
  ASSERT_EQ(s.remarks.size(), 1u);
  EXPECT_NE(s.remarks[0].find("less than the mesh can show"), std::string::npos) << s.remarks[0];
  EXPECT_LT(std::abs(stressError(s, vesselStress(), endMargin, vesselLength - endMargin).mean), meanLimit);
}

/// A flow rate of 2.5e-15 m^3/s: more decimals than OpenFOAM gives a number in an expression.
TEST(FoamBackend, poiseuilleInTheSlowestFlowAllowed) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FlowConditions slow = vesselConditions();
  const double slower = 1e-9 / meanVelocity;
  slow.flowRate *= slower;
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const auto s = backend.solve(tube(vesselRadius, vesselLength), slow, scratch / "case");
  const auto error = stressError(s, slower * vesselStress(), endMargin, vesselLength - endMargin);
  EXPECT_LT(std::abs(error.mean), meanLimit);
  EXPECT_LT(error.l2, l2Limit);
}

TEST(FoamBackend, poiseuilleAtFixedPressureGradient) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FlowConditions conditions = vesselConditions();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const auto s = backend.solve(tube(vesselRadius, vesselLength), conditions, scratch.path() / "case");
  const auto error = stressError(s, vesselStress(), endMargin, vesselLength - endMargin);
  EXPECT_LT(std::abs(error.mean), 0.003) << s.iterations << " iterations";
  EXPECT_NEAR(s.pressureDrop / (conditions.pressureGradient * vesselLength), 1.0, 1e-6);
}

/// The developed flow in a duct that is no tube; cells of 18 um at the wall.
TEST(FoamBackend, ellipticDuctTurnedAboutItsAxis) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.cellSize = 36e-6;
  FoamBackend backend(settings);
  const auto e = ellipticDuctError(backend, scratch / "case", endMargin);
  RecordProperty("stress", std::to_string(e.stress.l2));
  EXPECT_LT(e.stress.l2, 0.02);
  EXPECT_LT(std::abs(e.stress.mean), 0.01);
  EXPECT_LT(std::abs(e.pressureDrop), 0.03);
  EXPECT_LT(e.velocity, 0.01);
}

/// The developed flow between two tubes, whose inlet's centre lies in the inner one. The pressure gradient is
/// 8 mu Q / (pi (b^4 - a^4 - (b^2 - a^2)^2 / ln(b/a))) (Bird, Stewart and Lightfoot 2002, eq. 2.4-17).
TEST(FoamBackend, annulusHasItsOwnDevelopedProfile) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  constexpr double outer = 0.9e-3, inner = 0.45e-3, length = 0.8e-3;
  FoamSettings settings = FoamSettings::forFidelity("draft");
  settings.cellSize = 45e-6;
  FoamBackend backend(settings);
  const FlowConditions conditions = vesselConditions();
  const auto s = backend.solve(annularTube(outer, inner, length), conditions, scratch / "case");
  const double squares = outer * outer - inner * inner, ratio = std::log(outer / inner);
  const double gradient =
      8.0 * conditions.dynamicViscosity() * conditions.flowRate /
      (std::numbers::pi * (std::pow(outer, 4) - std::pow(inner, 4) - squares * squares / ratio));
  EXPECT_NEAR(s.pressureDrop / (gradient * length), 1.0, 0.03);
  // dw/dr of p^2 - r^2 + (p^2 - q^2) ln(r/p) / ln(p/q), times the gradient over 4
  const auto stress = [&](const Vec3& place) {
    const double r = place.head<2>().norm();
    return 0.25 * gradient * std::abs(-2.0 * r + squares / (ratio * r));
  };
  const auto error = stressError(s, stress, meanStress(s), endMargin, length - endMargin);
  EXPECT_LT(error.l2, 0.03);
  EXPECT_TRUE(s.remarks.empty());
}

/// In a tube that widens blood slows down and regains pressure (Bernoulli), more than friction takes.
TEST(FoamBackend, pressureRisesInADiffuser) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const double narrow = 0.6 * vesselRadius, length = 3e-3;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= 30; ++i)
    profile.push_back({narrow + (vesselRadius - narrow) * i / 30, length * i / 30});
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const FlowConditions conditions = vesselConditions();
  const auto s = backend.solve(revolve(profile), conditions, scratch.path() / "case");
  const double velocity = conditions.flowRate / (std::numbers::pi * narrow * narrow);
  const double brought = conditions.density * velocity * velocity;
  EXPECT_LT(s.pressureDrop, -0.05 * brought);
  EXPECT_GT(s.pressureDrop, -brought);
  EXPECT_TRUE(s.remarks.empty());
}

TEST(FoamBackend, strutRaisesStressOnItsTopAndLowersItBeside) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  const auto s = backend.solve(stentedTube(vesselRadius, vesselLength, 90e-6), vesselConditions(),
                               scratch.path() / "case");
  const StrutTop top = expectStrutDisturbs(s, 0.82e-3);
  EXPECT_GT(top.stress, 1.5 * vesselStress());
  EXPECT_NEAR(top.area / (2.0 * std::numbers::pi * 0.81e-3 * 90e-6), 1.0, 0.1);
}

}  // namespace
}  // namespace restenosis
