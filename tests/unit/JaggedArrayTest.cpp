#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "tissue/agents/JaggedArray.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

using Lists = std::vector<std::vector<int>>;

Lists listsOf(const JaggedArray<int>& lists) {
  Lists found;
  for (std::size_t k = 0; k < lists.size(); ++k) found.emplace_back(lists[k].begin(), lists[k].end());
  return found;
}

/// Lists as long as their numbers, and one longer than a list may have spare capacity.
JaggedArray<int> longAndShort() {
  JaggedArray<int> lists;
  lists.layOut(3, [](std::size_t k) { return k == 2 ? 1000 : k; });
  for (std::size_t k = 0; k < 3; ++k)
    for (int& element : lists[k]) element = static_cast<int>(k);
  return lists;
}

TEST(JaggedArray, LaysListsOutAsLongAsTheyAreAskedFor) {
  const JaggedArray<int> lists = longAndShort();
  EXPECT_EQ(listsOf(lists), (Lists{{}, {1}, std::vector<int>(1000, 2)}));
  EXPECT_EQ(lists.elementCount(), 1001U);
  EXPECT_FALSE(lists.wasteful());
}

TEST(JaggedArray, AppendsListsOneAfterTheOther) {
  JaggedArray<int> lists = longAndShort();
  lists.addList(std::vector<int>{7, 8});
  lists.addList({});
  EXPECT_EQ(listsOf(lists), (Lists{{}, {1}, std::vector<int>(1000, 2), {7, 8}, {}}));
  EXPECT_FALSE(lists.wasteful());
}

TEST(JaggedArray, ReservedMemoryKeepsListsWhereTheyAre) {
  JaggedArray<int> lists;
  lists.reserve(100, 1000);
  const std::vector<int> list(10, 7);
  lists.addList(list);
  const int* const first = lists[0].data();
  for (int n = 1; n < 100; ++n) lists.addList(list);
  EXPECT_EQ(lists[0].data(), first);
  EXPECT_EQ(listsOf(lists), Lists(100, list));
}

TEST(JaggedArray, SpreadsListsWithoutChangingThem) {
  JaggedArray<int> lists = longAndShort();
  const Lists before = listsOf(lists);
  lists.spread([](std::size_t k) { return static_cast<std::uint32_t>(2 * k); });
  EXPECT_EQ(listsOf(lists), before);
  const int* const first = lists[1].data();
  for (const int element : {5, 6}) lists.append(1, element, 0);
  EXPECT_EQ(listsOf(lists)[1], (std::vector<int>{1, 5, 6}));
  EXPECT_EQ(lists[1].data(), first) << "there was capacity for two";
  EXPECT_EQ(listsOf(lists)[2], before[2]);
}

TEST(JaggedArray, InsertsAndErasesAnywhere) {
  JaggedArray<int> lists = longAndShort();
  for (const auto& [position, element] : {std::pair<std::size_t, int>{0, 5}, {2, 7}, {1, 6}})
    lists.insert(1, position, element, 1);
  EXPECT_EQ(listsOf(lists)[1], (std::vector<int>{5, 6, 1, 7}));
  lists.erase(1, 2);
  lists.erase(1, 0);
  EXPECT_EQ(listsOf(lists)[1], (std::vector<int>{6, 7}));
  lists.erase(1, 1);
  lists.erase(1, 0);
  EXPECT_TRUE(lists[1].empty());
  EXPECT_EQ(listsOf(lists)[2], std::vector<int>(1000, 2));
}

TEST(JaggedArray, HoldsWhatListsWereGiven) {
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  const auto below = [&](std::size_t limit) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(limit));
  };
  JaggedArray<int> lists;
  Lists expected;
  bool everWasteful = false;
  for (int step = 0; step < 20000; ++step) {
    if (step % 200 == 0) {
      expected.resize(expected.size() + 3);
      lists.resize(expected.size());
    }
    const std::size_t list = below(expected.size());
    std::vector<int>& wanted = expected[list];
    switch (below(4)) {
      case 0:
        wanted = std::vector<int>(below(step % 500 == 0 ? 2000 : 12), step);
        lists.set(list, wanted, 2);
        break;
      case 1:
        if (wanted.empty()) break;
        lists.erase(list, wanted.size() / 2);
        wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(wanted.size() / 2));
        break;
      default:
        wanted.push_back(step);
        lists.append(list, step, 3);
    }
    if (lists.wasteful()) {
      everWasteful = true;
      lists.compact(static_cast<std::uint32_t>(step % 3));
      EXPECT_FALSE(lists.wasteful());
      ASSERT_EQ(listsOf(lists), expected) << "after step " << step;
    }
  }
  EXPECT_TRUE(everWasteful);
  EXPECT_EQ(listsOf(lists), expected);
}

TEST(JaggedArray, AListThatShrinksFarKeepsNoMoreThanItMayHaveSpare) {
  JaggedArray<int> lists = longAndShort();
  lists.set(2, std::vector<int>{2}, 0);
  EXPECT_TRUE(lists.wasteful()) << "most of a thousand places";
  lists.set(2, std::vector<int>(JaggedArray<int>::mostSpare + 2, 7), 0);
  EXPECT_EQ(listsOf(lists)[2], std::vector<int>(JaggedArray<int>::mostSpare + 2, 7));
}

TEST(JaggedArray, LaidOutAgainHasNothingOfBefore) {
  JaggedArray<int> lists = longAndShort();
  lists.set(2, std::vector<int>{2}, 0);
  lists.layOut(2, [](std::size_t) { return 1; });
  EXPECT_FALSE(lists.wasteful());
  EXPECT_EQ(lists.size(), 2U);
  EXPECT_EQ(lists.elementCount(), 2U);
}

TEST(JaggedArray, ComesBackFromAnArchive) {
  JaggedArray<int> lists = longAndShort();
  lists.append(0, 9, 3);
  WritingArchive writing;
  writing(lists);
  JaggedArray<int> read;
  ReadingArchive reading(writing.buffer());
  reading(read);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_EQ(listsOf(read), listsOf(lists));
  read.append(0, 8, 3);
  EXPECT_EQ(listsOf(read)[0], (std::vector<int>{9, 8}));
}

TEST(JaggedArray, RefusesMoreThanItCanAddress) {
  JaggedArray<char> lists;
  EXPECT_THROW(lists.layOut(1, [](std::size_t) { return std::size_t{1} << 24; }), std::length_error);
  EXPECT_THROW(lists.layOut(300, [](std::size_t) { return (std::size_t{1} << 24) - 1; }), std::length_error);
}

}  // namespace
}  // namespace restenosis
