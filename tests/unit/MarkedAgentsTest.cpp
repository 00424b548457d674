#include <gtest/gtest.h>

#include "tissue/agents/MarkedAgents.h"

namespace restenosis {
namespace {

bool any(Index) { return true; }

TEST(MarkedAgents, AreNoneAtFirstAndAfterTheyWereExtracted) {
  MarkedAgents marked;
  marked.resize(3);
  EXPECT_TRUE(marked.extract(any).empty());
  marked.mark(2);
  marked.resize(1000);
  marked.mark(999);
  EXPECT_EQ(marked.extract(any), (std::vector<Index>{2, 999}));
  EXPECT_TRUE(marked.extract(any).empty());
}

TEST(MarkedAgents, AreExtractedInAscendingOrderWhicheverThreadMarkedThem) {
  for (const Index count : {1U, 255U, 256U, 257U, 100'000U}) {
    MarkedAgents marked;
    marked.resize(count);
    std::vector<Index> expected, odd;
    for (Index i = 0; i < count; i += 1 + i / 7) expected.push_back(i);
    for (const Index i : expected)
      if (i % 2 == 1) odd.push_back(i);
    const auto markAll = [&] {
      forEachInChunks(expected.size(),
                      [&](std::size_t k) { marked.mark(expected[expected.size() - 1 - k]); });
    };
    markAll();
    EXPECT_EQ(marked.extract(any), expected) << count;
    markAll();
    EXPECT_EQ(marked.extract([](Index i) { return i % 2 == 1; }), odd) << count;
    EXPECT_TRUE(marked.extract(any).empty()) << "those not wanted are no longer marked";
    marked.markAll();
    EXPECT_EQ(marked.extract(any).size(), count);
  }
}

}  // namespace
}  // namespace restenosis
