#include <gtest/gtest.h>

#include <numeric>

#include "Minimiser.h"

namespace restenosis {
namespace {

/// One agent on a spring of unequal stiffness across and along the axis.
struct Spring {
  std::vector<Index> active{0};
  std::vector<AgentMotion> motion{{.stiffness = 2.0}};
  std::vector<double> radius{1.0};
  Vec3 position{0.3, -0.1, 0.2};

  Vec3 step(Minimiser& minimiser) {
    const MinimiserView view{active, motion, radius};
    StepTotals totals;
    minimiser.total(view, 0, 1, totals);
    minimiser.begin(totals);
    std::vector<Vec3> move(1);
    minimiser.step(view, 0, 1, move);
    return move[0];
  }

  double relax(Minimiser& minimiser, int steps) {
    double longest = 0;
    for (int k = 0; k < steps; ++k) {
      motion[0].force = -Vec3(2.0, 2.0, 0.5).cwiseProduct(position);
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
    spring.motion[0].force = {0.01, 0, 0.01};
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
  std::vector<Index> active(1000);
  std::iota(active.begin(), active.end(), Index{0});
  const std::vector<double> radius(1000, 1e3);
  MechanicsParameters p = minimisedBy("fire");
  p.axialForceFactor = 1;
  for (const double eigenvalue : {0.5, 1.0, 1.5}) {
    std::vector<AgentMotion> motion(1000, {.force = {1e-6, 0, 0}, .stiffness = 1, .velocity = {1e-4, 0, 0}});
    motion[0].velocity.setZero();
    const MinimiserView view{active, motion, radius};
    const auto fire = makeMinimiser(p);
    double displacement = 1e-9, farthest = 0;
    std::vector<Vec3> moves(active.size());
    for (int k = 0; k < 200; ++k) {
      motion[0].force.x() = -eigenvalue * motion[0].stiffness * displacement;
      StepTotals totals;
      fire->total(view, 0, active.size(), totals);
      fire->begin(totals);
      fire->step(view, 0, active.size(), moves);
      displacement += moves[0].x();
      farthest = std::max(farthest, std::abs(displacement));
    }
    EXPECT_LT(farthest, 1e-8) << eigenvalue;
    EXPECT_LT(std::abs(displacement), 1e-12) << eigenvalue;
    EXPECT_GT(motion[1].velocity.x(), 1e-5) << "the others were to drift";
  }
}

TEST(Minimiser, MovesAllAgentsAlikeInWhateverPieces) {
  const std::vector<Index> active{0, 2, 3};
  const std::vector<double> radius(4, 1.0);
  std::vector<AgentMotion> start(4, {.stiffness = 3.0});
  start[0].force = {0.02, 0, 0}, start[0].velocity = {0.01, 0, 0};
  start[2].force = {0, 0.01, 0.01}, start[2].velocity = {0, 0.02, -0.01};
  start[3].force = {-0.01, 0, 0}, start[3].velocity = {0.004, 0, 0};
  start[3].stiffness = 7;
  for (const auto name : minimiserNames()) {
    const auto moved = [&](std::size_t piece) {
      std::vector<AgentMotion> motion = start;
      const MinimiserView view{active, motion, radius};
      const auto minimiser = makeMinimiser(minimisedBy(name));
      StepTotals totals;
      for (std::size_t begin = 0; begin < active.size(); begin += piece) {
        StepTotals part;
        minimiser->total(view, begin, std::min(active.size(), begin + piece), part);
        totals.join(part);
      }
      minimiser->begin(totals);
      std::vector<Vec3> moves(active.size());
      for (std::size_t begin = 0; begin < active.size(); begin += piece) {
        minimiser->step(view, begin, std::min(active.size(), begin + piece), std::span(moves).subspan(begin));
      }
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
