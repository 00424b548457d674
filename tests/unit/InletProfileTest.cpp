#include <gtest/gtest.h>

#include "bridge/flow/foam/InletProfile.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/Constants.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(InletProfile, ACircleGivesTheParaboloid) {
  const auto profile = developedProfile(tube(vesselRadius, 1e-3));
  EXPECT_NEAR(profile.radius, vesselRadius, 1e-9);
  EXPECT_NEAR(profile.constant, 1.0, 1e-3);
  EXPECT_LT(profile.rimError, 1e-3);  // the rim is a polygon
  for (const double r : {0.0, 0.3, 0.7}) EXPECT_NEAR(profile(r, 0.0), 1 - r * r, 1e-3);
  EXPECT_TRUE(profile.xAxis.isApprox(Vec3::UnitX()));
  EXPECT_TRUE(profile.direction.isApprox(Vec3::UnitZ()));
}

TEST(InletProfile, AnEllipseIsMetExactly) {
  TriSurface ellipse = tube(vesselRadius, 1e-3);
  constexpr double a = 1.3, b = 0.6;  // semi-axes over the radius
  for (Vec3& v : ellipse.vertices) v.x() *= a, v.y() *= b;
  const auto profile = developedProfile(ellipse);
  // Of Laplacian -4, zero where (x/a)^2 + (y/b)^2 = 1; in units of the equal-area circle's radius
  const double unit = std::sqrt(a * b), p = a / unit, q = b / unit;
  const double peak = 2 * p * p * q * q / (p * p + q * q);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {0.3, 0.4}, {-0.7, 0.2}})
    EXPECT_NEAR(profile(x, y), peak * (1 - x * x / (p * p) - y * y / (q * q)), 2e-3);
  EXPECT_LT(profile.rimError, 2e-3);
}

TEST(InletProfile, AShapeFarFromRoundIsKnownByItsRim) {
  TriSurface star = tube(vesselRadius, 1e-3);
  for (Vec3& v : star.vertices) {
    const double factor = 1 + 0.5 * std::cos(5 * std::atan2(v.y(), v.x()));
    v.head<2>() *= factor;
  }
  EXPECT_GT(developedProfile(star).rimError, 0.02);
}

/// Between two circles w = p^2 - r^2 + (p^2 - q^2) ln(r/p) / ln(p/q) vanishes at r = p and r = q.
TEST(InletProfile, AnAnnulusIsMetByItsLogarithm) {
  constexpr double outer = 0.9e-3, inner = 0.4e-3;
  const auto profile = developedProfile(annularTube(outer, inner, 1e-3));
  ASSERT_EQ(profile.holes.size(), 1u);
  const double unit = std::sqrt(outer * outer - inner * inner), p = outer / unit, q = inner / unit;
  EXPECT_NEAR(profile.radius / unit, 1.0, 1e-9);
  for (const double r : {0.5, 0.7, 0.9})
    EXPECT_NEAR(profile(0.6 * r, -0.8 * r),
                p * p - r * r + (p * p - q * q) * std::log(r / p) / std::log(p / q), 2e-3);
  EXPECT_LT(profile.rimError, 0.02);
  EXPECT_NE(profile.expression().find("log("), std::string::npos);
}

TEST(InletProfile, AHoleMayLieAside) {
  for (const double aside : {0.1e-3, 0.3e-3}) {
    const auto profile = developedProfile(annularTube(0.9e-3, 0.3e-3, 1e-3, aside));
    EXPECT_LT(profile.rimError, 0.1) << aside;
    const double middle = 0.5 * (-0.9e-3 + aside - 0.3e-3);
    EXPECT_GT(profile((middle - profile.centre.x()) / profile.radius, 0.0), 0.1);
  }
}

TEST(InletProfile, FollowsTheInletInAnyDirection) {
  const auto motion = motionTo(Vec3(1, 2, 3), Vec3(1e-3, 0, 0));
  const auto profile = developedProfile(moved(tube(vesselRadius, 1e-3), motion));
  EXPECT_TRUE(profile.direction.isApprox(Vec3(1, 2, 3).normalized()));
  EXPECT_NEAR((profile.centre - Vec3(1e-3, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(profile.xAxis.cross(profile.yAxis).dot(profile.direction), 1.0, 1e-12);
}

}  // namespace
}  // namespace restenosis
