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
using Remeshing = FoamBackend::Remeshing;

/// A backend whose first solve meshes `former`, and that is then to start from it.
FlowSolution solveAfter(const TriSurface& former, const TriSurface& lumen,
                        const std::filesystem::path& folder, Remeshing remeshing, int ranks = 1) {
  FoamBackend backend(FoamSettings::forFidelity("draft"), {.ranks = ranks}, remeshing);
  const FlowSolution first = backend.solve(former, vesselConditions(), folder / "first");
  EXPECT_FALSE(first.meshMoved);
  backend.startFrom(folder / "first");
  return backend.solve(lumen, vesselConditions(), folder / "second");
}

/// A tube whose square ring stays where it is, whatever the tube's radius.
TriSurface tubeAroundRing(double radius) {
  constexpr double inner = vesselRadius - 90e-6, a = 0.5 * (vesselLength - 90e-6), b = a + 90e-6;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i < 6; ++i) profile.push_back({radius, a * i / 6});
  profile.push_back({radius, a, SurfaceRegion::strut});
  profile.push_back({inner, a, SurfaceRegion::strut});
  profile.push_back({inner, b, SurfaceRegion::strut});
  for (int i = 0; i <= 6; ++i) profile.push_back({radius, b + (vesselLength - b) * i / 6});
  return revolve(profile);
}

double meanStressOf(const FlowSolution& solution, SurfaceRegion region) {
  double sum = 0.0, area = 0.0;
  for (const WallFace& f : solution.wall)
    if (f.region == region) sum += f.area * f.traction.norm(), area += f.area;
  return sum / area;
}

/// The limits of a newly made mesh (FoamBackend.poiseuilleAtFixedFlowRate).
constexpr PoiseuilleLimits limits{
    .stressMean = 0.01, .stressL2 = 0.025, .pressureDrop = 0.03, .massImbalance = 1e-4, .endMargin = 0.1e-3};

TEST(FoamMorph, poiseuilleInAMeshThatFollowedTheWall) {
  RESTENOSIS_NEEDS_OPENFOAM();
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(ranks);
    const TemporaryFolder scratch;
    const auto s = solveAfter(tube(vesselRadius + 8e-6, vesselLength), tube(vesselRadius, vesselLength),
                              scratch.path(), Remeshing::onDemand, ranks);
    EXPECT_TRUE(s.meshMoved) << (s.remarks.empty() ? s.remeshedBecause : s.remarks[0]);
    expectPoiseuille(s, limits);
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / "second/case.foam"));
  }
}

TEST(FoamMorph, aMovedMeshGivesTheStressOfANewOneAroundARing) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto former = tubeAroundRing(vesselRadius + 10e-6), lumen = tubeAroundRing(vesselRadius);
  const auto moved = solveAfter(former, lumen, scratch / "moved", Remeshing::onDemand);
  const auto made = solveAfter(former, lumen, scratch / "made", Remeshing::always);
  ASSERT_TRUE(moved.meshMoved) << moved.remeshedBecause;
  ASSERT_FALSE(made.meshMoved);
  EXPECT_TRUE(made.remeshedBecause.empty());
  EXPECT_NEAR(moved.pressureDrop / made.pressureDrop, 1.0, 0.01);
  EXPECT_NEAR(meanStressOf(moved, SurfaceRegion::wall) / meanStressOf(made, SurfaceRegion::wall), 1.0, 0.02);
  // The stress at the ring's edges depends on the mesh
  EXPECT_NEAR(meanStressOf(moved, SurfaceRegion::strut) / meanStressOf(made, SurfaceRegion::strut), 1.0,
              0.05);
}

TEST(FoamMorph, theFormerFlowIsAShorterWayToTheSameStress) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto former = tubeAroundRing(vesselRadius + 5e-6), lumen = tubeAroundRing(vesselRadius);
  const auto warm = solveAfter(former, lumen, scratch / "warm", Remeshing::always);
  FoamBackend fromRest(FoamSettings::forFidelity("draft"));
  const auto cold = fromRest.solve(lumen, vesselConditions(), scratch / "cold");
  EXPECT_LT(warm.iterations, cold.iterations);
  ASSERT_EQ(warm.wall.size(), cold.wall.size());
  double difference = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < warm.wall.size(); ++i) {
    difference += warm.wall[i].area * (warm.wall[i].traction - cold.wall[i].traction).squaredNorm();
    scale += cold.wall[i].area * cold.wall[i].traction.squaredNorm();
  }
  EXPECT_GT(difference, 0.0);
  EXPECT_LT(std::sqrt(difference / scale), 0.005);
}

TEST(FoamMorph, aMeshThatCannotFollowIsMadeAnewAndSaysWhy) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const auto lumen = tube(vesselRadius, 0.4e-3);
  const auto expectRemeshed = [&](const std::string& reason, FoamSettings settings, const TriSurface& former,
                                  auto spoil) {
    SCOPED_TRACE(reason);
    const TemporaryFolder scratch;
    FoamBackend backend(settings, {}, Remeshing::onDemand);
    const auto first = backend.solve(former, vesselConditions(), scratch / "first");
    EXPECT_EQ(first.remeshedBecause, "there was no former mesh");
    EXPECT_TRUE(first.remarks.empty());
    spoil(scratch / "first");
    backend.startFrom(scratch / "first");
    const auto s = backend.solve(lumen, vesselConditions(), scratch / "second");
    EXPECT_FALSE(s.meshMoved);
    EXPECT_EQ(s.remeshedBecause, reason);
    ASSERT_EQ(s.remarks.size(), 1u);
    EXPECT_NE(s.remarks[0].find(reason), std::string::npos) << s.remarks[0];
    EXPECT_LT(stressError(s, vesselStress(), 0.1e-3, 0.3e-3).l2, 0.03);
  };
  const auto leave = [](const std::filesystem::path&) {};
  const FoamSettings draft = FoamSettings::forFidelity("draft");
  expectRemeshed("the wall moved too far", draft, tube(vesselRadius + 40e-6, 0.4e-3), leave);
  expectRemeshed("the mesh could not be moved", draft, tube(vesselRadius, 0.41e-3), leave);
  FoamSettings strict = draft;
  strict.morphNonOrthogonality = 1;
  expectRemeshed("the moved mesh is too non-orthogonal", strict, lumen, leave);
  FoamSettings close = draft;
  close.morphDeparture = 1e-6;
  expectRemeshed("the moved mesh does not follow the lumen", close, tube(vesselRadius + 2e-6, 0.4e-3), leave);
  expectRemeshed("the former case could not be read", draft, lumen, [](const std::filesystem::path& folder) {
    std::filesystem::resize_file(folder / "constant/polyMesh/points", 2000);
  });
  expectRemeshed("the moved mesh failed a check", draft, lumen, [](const std::filesystem::path& folder) {
    std::filesystem::copy_file(folder / "constant/polyMesh/owner", folder / "constant/polyMesh/neighbour",
                               std::filesystem::copy_options::overwrite_existing);
  });
}

}  // namespace
}  // namespace restenosis
