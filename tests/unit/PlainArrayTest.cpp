#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "tissue/agents/PlainArray.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

PlainArray<int> oneTo(int last) {
  PlainArray<int> array;
  array.resize(static_cast<std::size_t>(last));
  std::iota(array.begin(), array.end(), 1);
  return array;
}

bool isOneTo(const PlainArray<int>& array, int last) {
  return array.size() == static_cast<std::size_t>(last) && std::ranges::equal(array, oneTo(last));
}

TEST(PlainArray, KeepsItsElementsWhereverItGrowsTo) {
  PlainArray<int> array = oneTo(3);
  for (const int size : {100, 10'000, 1'000'000}) {
    const std::size_t before = array.size();
    array.resize(static_cast<std::size_t>(size));
    std::iota(array.begin() + before, array.end(), static_cast<int>(before) + 1);
    EXPECT_TRUE(isOneTo(array, size)) << size;
  }
  array.resize(3);
  EXPECT_TRUE(isOneTo(array, 3));
  EXPECT_GE(array.capacity(), 1'000'000U);
}

TEST(PlainArray, IsCopiedAndMoved) {
  PlainArray<int> array = oneTo(4);
  PlainArray<int> copy = array;
  array.resize(2);
  EXPECT_TRUE(isOneTo(copy, 4));
  const PlainArray<int> moved = std::move(copy);
  EXPECT_TRUE(isOneTo(moved, 4));
  array = {};
  EXPECT_EQ(array.size(), 0U);
  EXPECT_EQ(array.capacity(), 0U);
}

TEST(PlainArray, RefusesMoreThanThereIs) {
  PlainArray<int> array = oneTo(4);
  EXPECT_THROW(array.reserve(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
  EXPECT_TRUE(isOneTo(array, 4));
}

TEST(PlainArray, ComesBackFromAnArchive) {
  PlainArray<int> array = oneTo(5), read;
  WritingArchive writing;
  writing(array);
  ReadingArchive reading(writing.buffer());
  reading(read);
  EXPECT_TRUE(isOneTo(read, 5));
  EXPECT_TRUE(reading.atEnd());
}

}  // namespace
}  // namespace restenosis
