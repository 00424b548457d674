#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {
namespace {

/// An agent as a minimiser sees it.
struct Mover {
  Vec3 velocity = Vec3::Zero();
  Vec3 force = Vec3::Zero();
  double stiffness = 1;
  double radius = 1;
};

void setForce(ActiveChunk& chunk, std::size_t k, const Vec3& force) {
  chunk.fx[k] = static_cast<float>(force.x());
  chunk.fy[k] = static_cast<float>(force.y());
  chunk.fz[k] = static_cast<float>(force.z());
}

/// A chunk of these agents.
std::unique_ptr<ActiveChunk> moversChunk(std::span<const Mover> movers) {
  auto chunk = std::make_unique<ActiveChunk>();
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const Mover& m = movers[k];
    chunk->set(k, AgentKind::smc, Vec3::Zero(), m.radius);
    chunk->stiffness[k] = static_cast<float>(m.stiffness);
    setForce(*chunk, k, m.force);
    chunk->vx[k] = m.velocity.x(), chunk->vy[k] = m.velocity.y(), chunk->vz[k] = m.velocity.z();
  }
  chunk->fillLanes(movers.size());
  return chunk;
}

Vec3 moveOf(const Moves& moves, std::size_t k) { return {moves.x[k], moves.y[k], moves.z[k]}; }

/// One agent on a spring of unequal stiffness across and along the axis.
struct Spring {
  std::unique_ptr<ActiveChunk> chunk = moversChunk(std::vector<Mover>{{.stiffness = 2.0}});
  Vec3 position{0.3, -0.1, 0.2};

  Vec3 step(Minimiser& minimiser) {
    StepTotals totals;
    minimiser.total(*chunk, 1, totals);
    minimiser.begin(totals);
    Moves moves;
    minimiser.step(*chunk, 1, moves);
    return moveOf(moves, 0);
  }

  double relax(Minimiser& minimiser, int steps) {
    double longest = 0;
    for (int k = 0; k < steps; ++k) {
      setForce(*chunk, 0, -Vec3(2.0, 2.0, 0.5).cwiseProduct(position));
      const Vec3 move = step(minimiser);
      position += move;
      longest = std::max(longest, move.norm());
    }
    return longest;
  }
};

RelaxationParameters minimisedBy(std::string_view minimiser) {
  RelaxationParameters p;
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
    setForce(*spring.chunk, 0, {0.01, 0, 0.01});
    const Vec3 move = spring.step(*makeMinimiser(minimisedBy(name)));
    EXPECT_NEAR(move.z() / move.x(), 2, 1e-12) << name;
  }
}

TEST(Minimiser, StopsAnAgentThatFeelsNoForce) {
  Spring spring;
  spring.chunk->vx[0] = 0.1;
  EXPECT_EQ(spring.step(*makeMinimiser(minimisedBy("fire"))), Vec3::Zero());
}

TEST(Minimiser, LeavesStiffAgentsAtRestWhileOthersDrift) {
  // One agent on a spring among two hundred that a constant force drives. Nothing may excite it: it comes to
  // rest as it would alone.
  RelaxationParameters p = minimisedBy("fire");
  p.axialForceFactor = 1;
  for (const double eigenvalue : {0.5, 1.0, 1.5}) {
    std::vector<Mover> movers(200, {.velocity = {1e-4, 0, 0}, .force = {1e-6, 0, 0}, .radius = 1e3});
    movers[0].velocity.setZero();
    const auto chunk = moversChunk(movers);
    const auto fire = makeMinimiser(p);
    double displacement = 1e-9, farthest = 0;
    Moves moves;
    for (int k = 0; k < 200; ++k) {
      chunk->fx[0] = -eigenvalue * chunk->stiffness[0] * displacement;
      StepTotals totals;
      fire->total(*chunk, movers.size(), totals);
      fire->begin(totals);
      fire->step(*chunk, movers.size(), moves);
      displacement += moves.x[0];
      farthest = std::max(farthest, std::abs(displacement));
    }
    EXPECT_LT(farthest, 1e-8) << eigenvalue;
    EXPECT_LT(std::abs(displacement), 1e-12) << eigenvalue;
    EXPECT_GT(chunk->vx[1], 1e-5) << "the others were to drift";
  }
}

TEST(Minimiser, MovesAllAgentsAlikeInWhateverChunks) {
  // More than the lanes of a step, and not a multiple of them.
  std::vector<Mover> start;
  for (int k = 0; k < 7; ++k) {
    const double turn = 0.3 * k;
    start.push_back({.velocity = {0.01, 0.02 * turn, -0.01},
                     .force = {0.02 - 0.01 * turn, 0.01 * turn, 0.01},
                     .stiffness = 3 + turn});
  }
  start[2].velocity = {0.004, 0, 0}, start[2].force = {-0.01, 0, 0};
  for (const auto name : minimiserNames()) {
    const auto moved = [&](std::size_t size) {
      std::vector<std::unique_ptr<ActiveChunk>> chunks;
      for (std::size_t begin = 0; begin < start.size(); begin += size)
        chunks.push_back(moversChunk(std::span(start).subspan(begin, std::min(size, start.size() - begin))));
      const auto countOf = [&](std::size_t chunk) { return std::min(size, start.size() - chunk * size); };
      const auto minimiser = makeMinimiser(minimisedBy(name));
      StepTotals totals;
      for (std::size_t n = 0; n < chunks.size(); ++n) {
        StepTotals part;
        minimiser->total(*chunks[n], countOf(n), part);
        totals.join(part);
      }
      minimiser->begin(totals);
      std::vector<Vec3> all;
      for (std::size_t n = 0; n < chunks.size(); ++n) {
        Moves moves;
        minimiser->step(*chunks[n], countOf(n), moves);
        for (std::size_t k = 0; k < countOf(n); ++k) all.push_back(moveOf(moves, k));
      }
      return all;
    };
    const std::vector<Vec3> all = moved(start.size());
    ASSERT_EQ(all.size(), start.size());
    for (const std::size_t size : {1, 2, 5}) {
      const std::vector<Vec3> inChunks = moved(size);
      for (std::size_t k = 0; k < all.size(); ++k)
        EXPECT_LT((inChunks[k] - all[k]).norm(), 1e-15) << name << ", agent " << k;
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
