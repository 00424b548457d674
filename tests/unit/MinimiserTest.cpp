#include <gtest/gtest.h>

#include <numeric>

#include "Minimiser.h"

namespace restenosis {
namespace {

/// One agent on a spring of unequal stiffness across and along the axis.
struct Spring {
  std::vector<AgentMotion> motion{{.now = {.stiffness = 2.0}, .radius = 1.0}};
  Vec3 position{0.3, -0.1, 0.2};

  Vec3 step(Minimiser& minimiser) {
    StepTotals totals;
    minimiser.total(motion, totals);
    minimiser.begin(totals);
    std::vector<Vec3> move(1);
    minimiser.step(motion, move);
    return move[0];
  }

  double relax(Minimiser& minimiser, int steps) {
    double longest = 0;
    for (int k = 0; k < steps; ++k) {
      motion[0].now.force = -Vec3(2.0, 2.0, 0.5).cwiseProduct(position);
      const Vec3 move = step(minimiser);
      position += move;
      longest = std::max(longest, move.norm());
    }
    return longest;
  }
};

MechanicsParameters minimisedBy(std::string_view minimiser) {
  MechanicsParameters p;
  p.minimiser = minimiser;
  return p;
}

TEST(Minimiser, FindsTheBottomAndKeepsTheStepLimit) {
  for (const auto name : minimiserNames()) {
    Spring spring;
    const double longest = spring.relax(*makeMinimiser(minimisedBy(name)), 300);
    EXPECT_LT(spring.position.norm(), 1e-6) << name;
    EXPECT_LE(longest, 0.05 * (1 + 1e-12)) << name;
    EXPECT_GT(longest, 0.01) << name;
  }
}

TEST(Minimiser, MovesAlongTheAxisByTheAxialFactor) {
  for (const auto name : minimiserNames()) {
    Spring spring;
    spring.motion[0].now.force = {0.01, 0, 0.01};
    const Vec3 move = spring.step(*makeMinimiser(minimisedBy(name)));
    EXPECT_NEAR(move.z() / move.x(), 2, 1e-12) << name;
  }
}

TEST(Minimiser, StopsAnAgentThatFeelsNoForce) {
  Spring spring;
  spring.motion[0].velocity = {0.1, 0, 0};
  EXPECT_EQ(spring.step(*makeMinimiser(minimisedBy("fire"))), Vec3::Zero());
}

TEST(Minimiser, LeavesStiffAgentsAtRestWhileOthersDrift) {
  // One agent on a spring among a thousand that a constant force drives. Nothing may excite it: it comes to
  // rest as it would alone.
  MechanicsParameters p = minimisedBy("fire");
  p.axialForceFactor = 1;
  for (const double eigenvalue : {0.5, 1.0, 1.5}) {
    std::vector<AgentMotion> motion(
        1000, {.velocity = {1e-4, 0, 0}, .now = {.force = {1e-6, 0, 0}, .stiffness = 1}, .radius = 1e3});
    motion[0].velocity.setZero();
    const auto fire = makeMinimiser(p);
    double displacement = 1e-9, farthest = 0;
    std::vector<Vec3> moves(motion.size());
    for (int k = 0; k < 200; ++k) {
      motion[0].now.force.x() = -eigenvalue * motion[0].now.stiffness * displacement;
      StepTotals totals;
      fire->total(motion, totals);
      fire->begin(totals);
      fire->step(motion, moves);
      displacement += moves[0].x();
      farthest = std::max(farthest, std::abs(displacement));
    }
    EXPECT_LT(farthest, 1e-8) << eigenvalue;
    EXPECT_LT(std::abs(displacement), 1e-12) << eigenvalue;
    EXPECT_GT(motion[1].velocity.x(), 1e-5) << "the others were to drift";
  }
}

TEST(Minimiser, MovesAllAgentsAlikeInWhateverPieces) {
  std::vector<AgentMotion> start(3, {.now = {.stiffness = 3.0}, .radius = 1.0});
  start[0].now.force = {0.02, 0, 0}, start[0].velocity = {0.01, 0, 0};
  start[1].now.force = {0, 0.01, 0.01}, start[1].velocity = {0, 0.02, -0.01};
  start[2].now.force = {-0.01, 0, 0}, start[2].velocity = {0.004, 0, 0};
  start[2].now.stiffness = 7;
  for (const auto name : minimiserNames()) {
    const auto moved = [&](std::size_t piece) {
      std::vector<AgentMotion> motion = start;
      const auto pieceAt = [&](std::size_t begin) {
        return std::span(motion).subspan(begin, std::min(piece, motion.size() - begin));
      };
      const auto minimiser = makeMinimiser(minimisedBy(name));
      StepTotals totals;
      for (std::size_t begin = 0; begin < motion.size(); begin += piece) {
        StepTotals part;
        minimiser->total(pieceAt(begin), part);
        totals.join(part);
      }
      minimiser->begin(totals);
      std::vector<Vec3> moves(motion.size());
      for (std::size_t begin = 0; begin < motion.size(); begin += piece)
        minimiser->step(pieceAt(begin), std::span(moves).subspan(begin));
      return moves;
    };
    const std::vector<Vec3> all = moved(3);
    for (const std::size_t piece : {1, 2}) {
      for (std::size_t k = 0; k < all.size(); ++k)
        EXPECT_LT((moved(piece)[k] - all[k]).norm(), 1e-15) << name << ", agent " << k;
    }
    for (const Vec3& move : all) EXPECT_GT(move.norm(), 0) << name;
  }
}

TEST(Minimiser, SaysWhichNamesThereAre) {
  try {
    makeMinimiser(minimisedBy("newton"));
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(), "unknown minimiser 'newton'; known: fire, overdamped");
  }
}

}  // namespace
}  // namespace restenosis
