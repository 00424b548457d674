#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tissue/equilibrium/ActiveSet.h"

namespace restenosis {
namespace {

/// The n-th of a chunk as it is expected of agent i.
void setAs(ActiveChunk& chunk, std::size_t n, Index i) {
  const double x = i;
  chunk.set(n, i % 2 == 0 ? AgentKind::smc : AgentKind::iel, {x, 2 * x, 3 * x}, 1 + x);
  const auto f = static_cast<float>(i);
  chunk.setForce(n, {f, 2 * f, 3 * f, 1 + f, 5 * f, 6 * f});
  chunk.vy[n] = 7 * f, chunk.path[n] = 8 * f, chunk.unreviewed[n] = 9 * f;
  chunk.listMargin[n] = 10 * f, chunk.constraintMargin[n] = 11 * f;
}

void add(ActiveSet& active, const std::vector<Index>& agents) {
  active.add(agents, [&](ActiveChunk& chunk, std::size_t n, std::size_t k) { setAs(chunk, n, agents[k]); });
}

/// Whether the set is these agents, each with all that is its own.
void expectSet(const ActiveSet& active, const std::vector<Index>& agents) {
  ASSERT_EQ(std::vector<Index>(active.agents().begin(), active.agents().end()), agents);
  for (std::size_t place = 0; place < agents.size(); ++place) {
    const Index i = agents[place];
    EXPECT_TRUE(active.contains(i));
    EXPECT_EQ(active.placeOf(i), place);
    const ActiveChunk& chunk = active.chunkOf(place);
    const std::size_t k = ActiveSet::inChunk(place);
    ActiveChunk expected;
    setAs(expected, 0, i);
    ASSERT_EQ(chunk.position(k), expected.position(0)) << i;
    ASSERT_EQ(chunk.kind[k], expected.kind[0]) << i;
    ASSERT_EQ(chunk.radius[k], expected.radius[0]) << i;
    const AgentForce now = chunk.force(k), then = expected.force(0);
    ASSERT_EQ((std::array{now.fx, now.fy, now.fz, now.stiffness, now.residual, now.stress}),
              (std::array{then.fx, then.fy, then.fz, then.stiffness, then.residual, then.stress}))
        << i;
    ASSERT_EQ((std::array{chunk.vy[k], chunk.path[k], chunk.unreviewed[k], chunk.listMargin[k],
                          chunk.constraintMargin[k]}),
              (std::array{expected.vy[0], expected.path[0], expected.unreviewed[0], expected.listMargin[0],
                          expected.constraintMargin[0]}))
        << i;
  }
}

TEST(ActiveSet, KeepsTheOrderInWhichAgentsWereAdded) {
  ActiveSet active;
  active.reset(2000);
  EXPECT_TRUE(active.empty());
  std::vector<Index> thirds, others, all, kept;
  for (Index i = 0; i < 2000; ++i) {
    (i % 3 == 0 ? thirds : others).push_back(i);
  }
  all = thirds;
  all.insert(all.end(), others.begin(), others.end());
  add(active, thirds);
  expectSet(active, thirds);
  EXPECT_FALSE(active.contains(1));
  add(active, others);
  expectSet(active, all);

  std::vector<std::uint8_t> keep(active.size());
  for (Index i = 0; i < 2000; ++i) {
    keep[i] = i % 7 == 2 || i > 1990;
    if (keep[i]) kept.push_back(all[i]);
  }
  active.keepOnly(keep);
  expectSet(active, kept);
  EXPECT_FALSE(active.contains(all[0]));
  active.reset(3000);
  EXPECT_TRUE(active.empty());
  EXPECT_FALSE(active.contains(all[2]));
  EXPECT_FALSE(active.contains(2999));
}

TEST(ActiveSet, ForgetsThePairsOfAgentsThatAreOthersNow) {
  ActiveSet active;
  active.reset(10);
  add(active, {1, 2});
  active.chunkOf(0).pairsCurrent = true;
  add(active, {5});
  EXPECT_FALSE(active.chunkOf(0).pairsCurrent);
  active.chunkOf(0).pairsCurrent = true;
  active.keepOnly(std::array<std::uint8_t, 3>{1, 0, 1});
  EXPECT_FALSE(active.chunkOf(0).pairsCurrent);
}

TEST(ActiveSet, SumsAndGathersInOrder) {
  ActiveSet active;
  active.reset(5000);
  std::vector<Index> agents;
  for (Index i = 1; i < 5000; i += 2) agents.push_back(i);
  add(active, agents);
  struct Sum {
    double x = 0;
    void join(const Sum& other) { x += other.x; }
  };
  const Sum sum = active.reduce<Sum>([](const ActiveChunk& chunk, std::span<const Index> of, Sum& part) {
    for (std::size_t k = 0; k < of.size(); ++k) part.x += chunk.x[k];
  });
  EXPECT_EQ(sum.x, 2500.0 * 2500.0);
  const auto places = active.gather(
      [](const ActiveChunk&, std::span<const Index> of, std::size_t first, std::vector<Index>& found) {
        for (std::size_t k = 0; k < of.size(); k += 100) found.push_back(static_cast<Index>(first + k));
      });
  for (std::size_t n = 0; n < places.size(); ++n)
    EXPECT_EQ(places[n], n / 3 * ActiveChunk::capacity + n % 3 * 100) << n;
}

TEST(ActiveSet, FillsTheLastLanesWithAgentsAtRest) {
  ActiveSet active;
  active.reset(100);
  std::vector<Index> agents;
  for (Index i = 50; i < 50 + 2 * ActiveChunk::lanes; ++i) agents.push_back(i);
  add(active, agents);
  std::vector<std::uint8_t> keep(agents.size(), 0);
  std::fill_n(keep.begin(), ActiveChunk::lanes + 1, 1);
  active.keepOnly(keep);
  const ActiveChunk& chunk = active.chunkOf(0);
  EXPECT_GT(chunk.residual[ActiveChunk::lanes], 0);
  for (std::size_t k = active.size(); k < 2 * ActiveChunk::lanes; ++k) {
    EXPECT_EQ(chunk.force(k).fx, 0) << k;
    EXPECT_EQ(chunk.residual[k], 0) << k;
    EXPECT_GT(chunk.stiffness[k], 0) << k;
    EXPECT_GT(chunk.radius[k], 0) << k;
  }
}

}  // namespace
}  // namespace restenosis
