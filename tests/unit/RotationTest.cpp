#include <gtest/gtest.h>

#include <numbers>

#include "bridge/surface/Rotation.h"

namespace restenosis {
namespace {

void expectTurns(const Vec3& from, const Vec3& to) {
  const Eigen::Matrix3d turn = rotationOnto(from, to);
  EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-14);
  EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(turn.determinant(), 1.0, 1e-14);
}

TEST(Rotation, turnsOneDirectionIntoAnother) {
  expectTurns(Vec3(1, 2, 3), Vec3(0, 0, 2));
  expectTurns(Vec3(0, 0, 1), Vec3(1e-9, 0, 1));
  expectTurns(Vec3(0, 0, 1), Vec3(0, 1e-9, -1));
}

TEST(Rotation, ofParallelAndOppositeDirections) {
  EXPECT_EQ(rotationOnto(Vec3(0, 0, 2), Vec3(0, 0, 1)), Eigen::Matrix3d::Identity());
  expectTurns(Vec3(1, 2, 3), Vec3(-1, -2, -3));
}

TEST(Rotation, isByTheSmallestAngle) {
  const Eigen::Matrix3d turn = rotationOnto(Vec3(1, 0, 0), Vec3(1, 1, 0));
  EXPECT_NEAR(turn.trace(), 1.0 + 2.0 * std::cos(std::numbers::pi / 4), 1e-14);
}

}  // namespace
}  // namespace restenosis
