#include <gtest/gtest.h>

#include "tissue/agents/AgentMarks.h"

namespace restenosis {
namespace {

bool any(Index) { return true; }

TEST(AgentMarks, OfNewAgentsAreSet) {
  AgentMarks marks;
  EXPECT_TRUE(marks.those(any).empty());
  marks.resize(3);
  EXPECT_EQ(marks.those(any), (std::vector<Index>{0, 1, 2}));
  marks.clear();
  marks.resize(5);
  EXPECT_EQ(marks.those(any), (std::vector<Index>{3, 4}));
}

TEST(AgentMarks, AreFoundInAscendingOrderWhicheverThreadSetThem) {
  for (const Index count : {1U, 255U, 256U, 257U, 100'000U}) {
    AgentMarks marks;
    marks.resize(count);
    marks.clear();
    EXPECT_TRUE(marks.those(any).empty());
    std::vector<Index> expected;
    for (Index i = 0; i < count; i += 1 + i / 7) expected.push_back(i);
    forEachInChunks(expected.size(), [&](std::size_t k) { marks.set(expected[expected.size() - 1 - k]); });
    EXPECT_EQ(marks.those(any), expected) << count;
    std::vector<Index> odd;
    for (const Index i : expected)
      if (i % 2 == 1) odd.push_back(i);
    EXPECT_EQ(marks.those([](Index i) { return i % 2 == 1; }), odd) << count;
    marks.clear();
    EXPECT_TRUE(marks.those(any).empty()) << count;
    marks.setAll();
    EXPECT_EQ(marks.those(any).size(), count);
  }
}

}  // namespace
}  // namespace restenosis
