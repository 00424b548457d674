#include <gtest/gtest.h>

#include "tissue/equilibrium/MovingAgents.h"

namespace restenosis {
namespace {

AgentMotion agentAt(double x) {
  return {.position = {x, 2 * x, 3 * x},
          .radius = 1 + x,
          .leash = static_cast<float>(4 * x),
          .kind = AgentKind::iel,
          .daughter = true};
}

TEST(MovingAgents, AreSetAtRestAndCopiedFromPieceToPiece) {
  MovingAgents moving;
  moving.resize(MotionPiece::most + 3);
  ASSERT_EQ(moving.pieces.size(), 2U);
  EXPECT_EQ(moving.agentsFrom(MotionPiece::most).size(), 3U);
  const std::size_t last = moving.size() - 1;
  moving.agents[last] = 77;
  moving.set(last, agentAt(5));
  EXPECT_EQ(moving.position(last), Vec3(5, 10, 15));
  EXPECT_EQ(moving.now(last).force, Vec3::Zero());
  moving.setNow(last, {.force = {1, 2, 3}, .stiffness = 4, .residual = 5});
  moving.pieceOf(last).vy[moving.inPiece(last)] = 6;
  moving.pieceOf(last).way[moving.inPiece(last)] = 7;

  moving.copy(1, last);
  const MotionPiece& first = moving.pieces.front();
  EXPECT_EQ(moving.agents[1], 77U);
  EXPECT_EQ(first.position(1), Vec3(5, 10, 15));
  EXPECT_EQ(first.force(1), Vec3(1, 2, 3));
  EXPECT_EQ(moving.now(1).stiffness, 4);
  EXPECT_EQ(moving.now(1).residual, 5);
  EXPECT_EQ(Vec3(first.vx[1], first.vy[1], first.vz[1]), Vec3(0, 6, 0));
  EXPECT_EQ(first.radius[1], 6);
  EXPECT_EQ(first.leash[1], 20);
  EXPECT_EQ(first.way[1], 7);
  EXPECT_EQ(first.kind[1], AgentKind::iel);
  EXPECT_TRUE(first.daughter[1]);
}

TEST(MovingAgents, HaveAgentsAtRestInWhatIsLeftOfTheLastLanes) {
  MovingAgents moving;
  moving.resize(2 * MotionPiece::lanes);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    moving.set(k, agentAt(1));
    moving.setNow(k, {.force = {1, 1, 1}, .stiffness = 0, .residual = 1});
  }
  moving.resize(MotionPiece::lanes + 1);
  moving.fillLanes();
  EXPECT_EQ(moving.now(MotionPiece::lanes).residual, 1);
  for (std::size_t k = moving.size(); k < 2 * MotionPiece::lanes; ++k) {
    EXPECT_EQ(moving.now(k).force, Vec3::Zero()) << k;
    EXPECT_EQ(moving.now(k).residual, 0) << k;
    EXPECT_GT(moving.now(k).stiffness, 0) << k;
    EXPECT_GT(moving.pieceOf(k).radius[k], 0) << k;
  }
}

}  // namespace
}  // namespace restenosis
