#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/surface/RadialMap.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

LumenField cylinder(double radius, double bump = 0) {
  return LumenField::fromFunction(
      [=](const Vec3& p) {
        const double r = std::hypot(p.x(), p.y());
        const double angle = std::atan2(p.y(), p.x());
        // The bump takes 2 % of the angles, on half of the length.
        const bool on = std::abs(angle) < 0.02 * std::numbers::pi && p.z() < 5;
        return radius - (on ? bump : 0) - r;
      },
      10, 6, 0.25);
}

TEST(RadialMap, MeasuresACylinder) {
  const RadialMap map(cylinder(4));
  EXPECT_NEAR(map.meanRadius(), 4, 0.005);
  EXPECT_NEAR(map.lumenArea(7), std::numbers::pi * 16, 0.1);
  EXPECT_NEAR(map.minimalArea(), std::numbers::pi * 16, 0.1);
}

TEST(RadialMap, OfARoundLumenIsExact) {
  const auto radius = [](double z) { return 3 + z / 8; };
  const RadialMap map = RadialMap::ofRound(radius, 10, 0.25);
  ASSERT_EQ(map.planes(), 41);
  EXPECT_EQ(map.z(40), 10);
  for (const int k : {0, 7, 40}) {
    EXPECT_EQ(map.radius(k, 123), radius(map.z(k)));
    EXPECT_NEAR(map.lumenArea(k), std::numbers::pi * radius(map.z(k)) * radius(map.z(k)), 1e-12);
  }
  const RadialMap sampled(LumenField::fromFunction(
      [&](const Vec3& p) { return radius(p.z()) - std::hypot(p.x(), p.y()); }, 10, 6, 0.25));
  EXPECT_TRUE(map.comparable(sampled));
  EXPECT_LT(displacement(map, sampled).largest, 0.005);
}

TEST(RadialMap, SmallestCrossSectionIsThatOfTheSectionAskedFor) {
  // Narrowest at z = 0, and again, less so, at z = 8.
  const auto radius = [](double z) {
    return z < 4 ? 3 + z / 8 : 4 - std::max(0.0, 0.5 - std::abs(z - 8) / 4);
  };
  const RadialMap map(LumenField::fromFunction(
      [&](const Vec3& p) { return radius(p.z()) - std::hypot(p.x(), p.y()); }, 10, 6, 0.25));
  EXPECT_NEAR(map.minimalArea(), std::numbers::pi * 9, 0.1);
  EXPECT_NEAR(map.minimalArea(5, 10), std::numbers::pi * 3.5 * 3.5, 0.1);
  // Between two planes, 0.25 apart
  EXPECT_EQ(map.minimalArea(2.05, 2.1), map.minimalArea(2, 2));
  EXPECT_THROW(RadialMap().minimalArea(), std::invalid_argument);
}

TEST(RadialMap, RaysThatStartInTissueHaveNoLength) {
  // A bar across the lumen, attached to the wall.
  const RadialMap map(LumenField::fromFunction(
      [](const Vec3& p) { return std::min(4 - std::hypot(p.x(), p.y()), std::hypot(p.y(), p.z() - 5) - 1); },
      10, 6, 0.5));
  EXPECT_EQ(map.radius(10, 0), 0.0);
  EXPECT_GT(map.radius(0, 0), 3.9);
}

TEST(RadialMap, RadiusAtAPointIsThatOfItsPlaneAndAngle) {
  const auto radius = [](double z, double angle) { return 3 + z / 10 + 0.5 * std::cos(angle); };
  const RadialMap map(LumenField::fromFunction(
      [&](const Vec3& p) { return radius(p.z(), std::atan2(p.y(), p.x())) - std::hypot(p.x(), p.y()); }, 10,
      6, 0.25));
  for (const double angle : {0.0, 0.0123, 1.5, 3.14, 3.9, 6.2829}) {
    const Vec3 direction(std::cos(angle), std::sin(angle), 0);
    for (const double z : {0.0, 0.1, 4.33, 9.9, 10.0})
      EXPECT_NEAR(map.radiusAt(2 * direction + z * Vec3::UnitZ()), radius(z, angle), 0.01)
          << angle << ' ' << z;
    EXPECT_NEAR(map.radiusAt(direction - Vec3::UnitZ()), radius(0, angle), 0.01);
    EXPECT_NEAR(map.radiusAt(direction + 12 * Vec3::UnitZ()), radius(10, angle), 0.01);
  }
}

TEST(RadialMap, DisplacementSeesUniformGrowthAndDiscountsASpot) {
  const RadialMap wide(cylinder(4)), narrow(cylinder(3.5)), spot(cylinder(4, 1));
  const LumenDisplacement all = displacement(wide, narrow), one = displacement(wide, spot);
  EXPECT_NEAR(all.mean, 0.5, 0.01);
  EXPECT_NEAR(all.robust, 0.5, 0.03);
  EXPECT_NEAR(one.largest, 1, 0.1);
  EXPECT_LT(one.mean, 0.03);
  EXPECT_EQ(displacement(wide, wide).largest, 0.0);
  EXPECT_THROW(displacement(wide, RadialMap(cylinder(4), 90)), std::invalid_argument);
}

TEST(RadialMap, MeasuresNeointima) {
  const Neointima n = measureNeointima(RadialMap(cylinder(4)), RadialMap(cylinder(3)), 2, 8);
  EXPECT_NEAR(n.meanThickness, 1, 0.01);
  EXPECT_NEAR(n.meanAreaFraction, 1 - 9.0 / 16, 0.01);
  EXPECT_EQ(n.z.size(), 25U);
  // Between two planes the nearest one counts
  const Neointima between = measureNeointima(RadialMap(cylinder(4)), RadialMap(cylinder(3)), 2.05, 2.1);
  EXPECT_EQ(between.z.size(), 1u);
  EXPECT_NEAR(between.meanThickness, 1, 0.01);
  EXPECT_THROW(measureNeointima(RadialMap(), RadialMap(), 2, 8), std::invalid_argument);
}

TEST(RadialMap, SurvivesAnArchive) {
  RadialMap map(cylinder(4, 1)), copy;
  WritingArchive out;
  out(map);
  ReadingArchive in(out.buffer());
  in(copy);
  EXPECT_TRUE(in.atEnd());
  EXPECT_EQ(displacement(map, copy).largest, 0.0);
}

}  // namespace
}  // namespace restenosis
