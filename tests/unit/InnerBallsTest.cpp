#include <gtest/gtest.h>

#include "bridge/surface/InnerBalls.h"
#include "tests/support/StrutSolids.h"

namespace restenosis {
namespace {

using namespace support;

std::vector<Facet> facetsOf(const TriSurface& s) {
  std::vector<Facet> facets;
  for (const auto& t : s.triangles) facets.push_back({s.vertices[t[0]], s.vertices[t[1]], s.vertices[t[2]]});
  return facets;
}

void expectBall(const std::optional<Ball>& ball, const Vec3& centre, double radius) {
  ASSERT_TRUE(ball.has_value());
  EXPECT_NEAR((ball->centre - centre).norm(), 0, 0.02 * radius) << ball->centre.transpose();
  EXPECT_NEAR(ball->radius, radius, 0.02 * radius);
}

TEST(InnerBalls, TouchTheFaceAndNearEdgesAndCornersTheOtherFacesToo) {
  const InnerBalls balls(facetsOf(box(Vec3::Zero(), {10, 10, 10})), 1, 0.1);
  expectBall(balls.at({10, 5, 4}, Vec3::UnitX()), {9, 5, 4}, 1);
  expectBall(balls.at({10, 9.8, 4}, Vec3::UnitX()), {9, 9, 4}, 1);
  expectBall(balls.at({10, 9.8, 0.3}, Vec3::UnitX()), {9, 9, 1}, 1);
}

TEST(InnerBalls, AreNoThickerThanTheSolid) {
  const InnerBalls balls(facetsOf(box(Vec3::Zero(), {1, 10, 10})), 2, 0.1);
  expectBall(balls.at({1, 5, 5}, Vec3::UnitX()), {0.5, 5, 5}, 0.5);
  expectBall(balls.at({1, 9.9, 5}, Vec3::UnitX()), {0.5, 9.5, 5}, 0.5);
  expectBall(balls.at({0.3, 10, 5}, Vec3::UnitY()), {0.5, 9.5, 5}, 0.5);
}

TEST(InnerBalls, NoneIsSmallerThanTheLeast) {
  const InnerBalls balls(facetsOf(box(Vec3::Zero(), {1, 10, 10})), 2, 0.6);
  EXPECT_FALSE(balls.at({1, 5, 5}, Vec3::UnitX()).has_value());
}

}  // namespace
}  // namespace restenosis
