#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/surface/Centreline.h"

namespace restenosis {
namespace {

constexpr double radius = 20e-3, length = 4.5e-3;

TEST(Centreline, ThatIsStraightAlongZChangesNothing) {
  const Centreline line = Centreline::through({Vec3(0, 0, 0), Vec3(0, 0, 2e-3), Vec3(0, 0, length)});
  EXPECT_NEAR(line.length(), length, 1e-15);
  EXPECT_NEAR(line.largestCurvature(), 0, 1e-9);
  for (const Vec3& p : {Vec3(1e-3, 2e-4, 3e-3), Vec3(-5e-4, 1e-3, -1e-3), Vec3(0, 0, 6e-3)}) {
    EXPECT_NEAR((line.toBent(p) - p).norm(), 0, 1e-16);
    EXPECT_NEAR((line.toStraight(p) - p).norm(), 0, 1e-16);
    EXPECT_NEAR((line.vectorToBent(p, Vec3(1, 2, 3)) - Vec3(1, 2, 3)).norm(), 0, 1e-12);
  }
}

TEST(Centreline, OfAnArcIsACircle) {
  const Centreline line = Centreline::arc(radius, 0, length);
  EXPECT_NEAR(line.length() / length, 1, 1e-9);
  EXPECT_NEAR(line.largestCurvature() * radius, 1, 1e-6);
  const double angle = 3e-3 / radius;
  const Vec3 inner(0, 0.9e-3, 3e-3);  // y points to the centre of the circle
  const double fromCentre = radius - 0.9e-3;
  const Vec3 expected(0, radius - fromCentre * std::cos(angle), fromCentre * std::sin(angle));
  EXPECT_NEAR((line.toBent(inner) - expected).norm(), 0, 1e-10);
  EXPECT_NEAR((line.vectorToBent(inner, Vec3::UnitX()) - Vec3::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((line.vectorToBent(inner, Vec3::UnitZ()) - Vec3(0, std::sin(angle), std::cos(angle))).norm(), 0,
              1e-7);
}

TEST(Centreline, OfAnArcIsTheSameWhereverItBegins) {
  const Centreline line = Centreline::arc(radius, 0, length),
                   longer = Centreline::arc(radius, -3e-3, length + 2e-3);
  EXPECT_NEAR(longer.length(), length + 5e-3, 1e-12);
  for (const double place : {0.0, 1.23e-3, 4.5e-3})
    EXPECT_NEAR((line.toBent({5e-4, -6e-4, place}) - longer.toBent({5e-4, -6e-4, place})).norm(), 0, 1e-10);
  EXPECT_NEAR(longer.toBent({0, 0, -3e-3}).z(), -radius * std::sin(3e-3 / radius), 1e-12);
}

/// A helix, whose frame must not turn with it.
std::vector<Vec3> helix() {
  std::vector<Vec3> points;
  for (int n = 0; n <= 200; ++n) {
    const double turn = 4 * std::numbers::pi * n / 200;
    points.push_back(1e-3 * Vec3(5 * std::cos(turn), 5 * std::sin(turn), 2 * turn));
  }
  return points;
}

TEST(Centreline, GoesThereAndBack) {
  for (const Centreline& line : {Centreline::arc(5e-3, 0, 20e-3), Centreline::through(helix())})
    for (const double place : {-1e-3, 0.0, 0.1e-3, 7.77e-3, 19e-3, 25e-3})
      for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
        const Vec3 straight(2e-3 * std::cos(angle), 2e-3 * std::sin(angle), place);
        EXPECT_NEAR((line.toStraight(line.toBent(straight)) - straight).norm(), 0, 1e-9)
            << straight.transpose();
        const Vec3 vector(1, -2, 0.5);
        EXPECT_NEAR((line.vectorToStraight(straight, line.vectorToBent(straight, vector)) - vector).norm(), 0,
                    1e-12);
      }
}

TEST(Centreline, OfAHelixHasItsLengthAndCurvature) {
  const Centreline line = Centreline::through(helix());
  const double pitch = std::hypot(5, 2);
  EXPECT_NEAR(line.length() / (4 * std::numbers::pi * pitch * 1e-3), 1, 1e-4);
  EXPECT_NEAR(line.largestCurvature() * pitch * pitch / 5 * 1e-3, 1, 0.02);
}

TEST(Centreline, TurnsItsFrameAsLittleAsItCan) {
  const Centreline line = Centreline::through(helix());
  const double step = 1e-4;
  for (double place = 1e-3; place < 50e-3; place += 1e-3) {
    const auto before = line.at(place - step / 2), after = line.at(place + step / 2);
    // It turns with the tangent, not about it
    EXPECT_NEAR((after.x - before.x).dot(line.at(place).y) / step, 0, 1.0) << place;
  }
}

TEST(Centreline, NeedsPointsApart) {
  EXPECT_THROW(Centreline::through({Vec3(0, 0, 0)}), std::invalid_argument);
  EXPECT_THROW(Centreline::through({Vec3(0, 0, 0), Vec3(0, 0, 0)}), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
