#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

// Below, at and above a piece and the length from which several threads look.
constexpr std::size_t counts[]{0, 1, 255, 256, 257, 16383, 16384, 50001};

TEST(Chunks, FindAgentsInAscendingOrder) {
  for (const std::size_t count : counts) {
    const std::vector<Index> found = agentsThat(count, [](Index i) { return i % 7 == 3; });
    EXPECT_EQ(found.size(), (count + 3) / 7) << count;
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k], 7 * k + 3) << count;
  }
}

TEST(Chunks, KeepTheOrderOfAList) {
  for (const std::size_t count : counts) {
    std::vector<Index> agents(count);
    std::iota(agents.rbegin(), agents.rend(), Index{0});
    const std::vector<Index> found = agentsOf(agents, [](Index i) { return i % 2 == 0; });
    EXPECT_EQ(found.size(), (count + 1) / 2) << count;
    EXPECT_TRUE(std::ranges::is_sorted(found, std::greater())) << count;
  }
}

TEST(Chunks, JoinWhatPiecesTellInTheirOrder) {
  const auto told = gatherChunks(1000, [](std::size_t begin, std::size_t end, std::vector<Index>& out) {
    out.push_back(static_cast<Index>(begin));
    out.push_back(static_cast<Index>(end));
  });
  EXPECT_EQ(told, (std::vector<Index>{0, 256, 256, 512, 512, 768, 768, 1000}));
}

TEST(Chunks, TakeEveryElementOnceWithAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    for (const std::size_t count : counts) {
      std::vector<int> taken(count, 0);
      forEachInChunks(count, [&](std::size_t k) { ++taken[k]; });
      EXPECT_EQ(std::ranges::count(taken, 1), static_cast<std::ptrdiff_t>(count)) << threads << " threads";
    }
  }
  omp_set_num_threads(before);
}

TEST(Chunks, TakeEveryElementOnceInALoopWithinALoop) {
  std::vector<int> taken(20 * parallelFrom, 0);
  forEachChunk(
      20,
      [&](std::size_t begin, std::size_t) {
        forEachInChunks(parallelFrom, [&](std::size_t k) { ++taken[begin * parallelFrom + k]; });
      },
      1, 1);
  EXPECT_EQ(std::ranges::count(taken, 1), std::ssize(taken));
}

}  // namespace
}  // namespace restenosis
