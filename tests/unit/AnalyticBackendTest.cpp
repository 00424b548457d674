#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/flow/analytic/AnalyticBackend.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

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

/// A tube that narrows to half its radius on its way.
TriSurface narrowedTube() {
  return revolve({{0.9e-3, 0}, {0.9e-3, 0.4e-3}, {0.45e-3, 0.5e-3}, {0.45e-3, 1e-3}});
}

TEST(AnalyticBackend, aNarrowingFeelsEightTimesTheStressAtAGivenFlowRate) {
  const auto solution = AnalyticBackend().solve(narrowedTube(), vesselConditions(), {});
  EXPECT_NEAR(stressError(solution, 8.0 * vesselStress(), 0.6e-3, 0.9e-3).mean, 0.0, 1e-9);
}

TEST(AnalyticBackend, oneFlowRatePassesAllCrossSectionsAtAGivenPressureGradient) {
  FlowConditions conditions = vesselConditions();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  const auto solution = AnalyticBackend().solve(narrowedTube(), conditions, {});
  // Integral of (R0 / R)^4 over the wide part, the cone between the two radii, and the narrow part
  const double resistance = 0.4e-3 + 0.1e-3 * (8.0 - 1.0) / (3.0 * 0.5) + 16.0 * 0.5e-3;
  const double wide = vesselStress() * 1e-3 / resistance;
  EXPECT_NEAR(stressError(solution, wide, 0, 0.3e-3).mean, 0.0, 1e-3);
  EXPECT_NEAR(stressError(solution, 8.0 * wide, 0.6e-3, 0.9e-3).mean, 0.0, 1e-3);
  EXPECT_NEAR(solution.pressureDrop / (conditions.pressureGradient * 1e-3), 1.0, 1e-9);
}

TEST(AnalyticBackend, aVesselNarrowedAllAlongFeelsLessAtAGivenPressureGradient) {
  FlowConditions conditions = vesselConditions();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  const auto solution = AnalyticBackend().solve(tube(0.5 * vesselRadius, vesselLength), conditions, {});
  EXPECT_LT(stressError(solution, 0.5 * vesselStress(), 0, vesselLength).maximum, 1e-9);
}

TEST(AnalyticBackend, longTrianglesHaveTheStressOfEachPlace) {
  const double length = 10e-3;
  const auto solution = AnalyticBackend().solve(revolve({{vesselRadius, 0}, {0.6 * vesselRadius, length}}),
                                                vesselConditions(), {});
  const auto expected = [&](const Vec3& p) {
    return vesselStress() / std::pow(1.0 - 0.4 * p.z() / length, 3);
  };
  EXPECT_LT(stressError(solution, expected, vesselStress(), 0.05 * length, 0.95 * length).maximum, 1e-3);
  for (const double z : {0.05, 0.95})
    EXPECT_TRUE(std::ranges::any_of(solution.wall, [&](const WallFace& f) {
      return std::abs(f.centre.z() - z * length) < 0.02 * length;
    })) << z;
  double area = 0.0;
  for (const auto& face : solution.wall) area += face.area;
  EXPECT_NEAR(area / (1.6 * pi * vesselRadius * std::hypot(length, 0.4 * vesselRadius)), 1.0, 1e-3);
}

TEST(AnalyticBackend, shortTrianglesStayWhole) {
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  const auto solution = AnalyticBackend().solve(lumen, vesselConditions(), {});
  std::size_t face = 0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != SurfaceRegion::wall) continue;
    ASSERT_LT(face, solution.wall.size());
    EXPECT_EQ(solution.wall[face].centre, lumen.centre(t));
    EXPECT_EQ(solution.wall[face].area, lumen.areaVector(t).norm());
    ++face;
  }
  EXPECT_EQ(face, solution.wall.size());
}

/// A straight round tube whose axis leans by an angle from the normal of its ends.
TriSurface leaningTube(double angle, double length) {
  TriSurface lumen = tube(vesselRadius, length);
  for (Vec3& v : lumen.vertices) v.x() = v.x() / std::cos(angle) + v.z() * std::tan(angle);
  return lumen;
}

TEST(AnalyticBackend, obliqueEndsDoNotChangeTheStressOfATube) {
  for (const double degrees : {10.0, 30.0, 45.0}) {
    const double angle = degrees * pi / 180;
    const auto solution = AnalyticBackend().solve(leaningTube(angle, 4e-3), vesselConditions(), {});
    EXPECT_LT(stressError(solution, vesselStress(), 0, 4e-3).maximum, 1e-6) << degrees;
    const Vec3 axis(std::sin(angle), 0, std::cos(angle));
    for (const auto& face : solution.wall) ASSERT_NEAR(face.traction.normalized().dot(axis), 1.0, 1e-9);
    EXPECT_NEAR(solution.pressureDrop / (vesselConditions().pressureGradient * 4e-3 / std::cos(angle)), 1.0,
                1e-6);
  }
}

TEST(AnalyticBackend, theAxisFollowsALumenThatBendsBetweenParallelEnds) {
  TriSurface lumen = tube(0.25 * vesselRadius, 8e-3, 160);
  for (Vec3& v : lumen.vertices) v.x() += 0.5e-3 * (1 - std::cos(pi * v.z() / 8e-3));
  const auto solution = AnalyticBackend().solve(lumen, vesselConditions(), {});
  const double slope = 0.5e-3 * pi / 8e-3;  // half way; the planes of constant z cut circles
  const double stress = 64.0 * vesselStress() * std::pow(1 + slope * slope, 0.75);
  EXPECT_NEAR(stressError(solution, stress, 3.8e-3, 4.2e-3).mean, 0.0, 1e-3);
  EXPECT_NEAR(stressError(solution, 64.0 * vesselStress(), 0, 0.1e-3).mean, 0.0, 2e-3);
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
