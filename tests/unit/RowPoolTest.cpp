#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "tissue/agents/RandomStream.h"
#include "tissue/agents/RowPool.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

using Rows = std::vector<std::vector<int>>;

Rows rowsOf(const RowPool<int>& pool) {
  Rows rows;
  for (std::size_t k = 0; k < pool.size(); ++k) rows.emplace_back(pool[k].begin(), pool[k].end());
  return rows;
}

/// A row as long as its number, and longer ones than a row may have spare room.
RowPool<int> longAndShort() {
  RowPool<int> pool;
  pool.layOut(3, [](std::size_t k) { return k == 2 ? 1000 : k; });
  for (std::size_t k = 0; k < 3; ++k)
    for (int& element : pool[k]) element = static_cast<int>(k);
  return pool;
}

TEST(RowPool, LaysRowsOutAsLongAsTheyAreTold) {
  const RowPool<int> pool = longAndShort();
  EXPECT_EQ(rowsOf(pool), (Rows{{}, {1}, std::vector<int>(1000, 2)}));
  EXPECT_EQ(pool.elementCount(), 1001U);
  EXPECT_FALSE(pool.wasteful());
}

TEST(RowPool, TakesRowsOneAfterTheOther) {
  RowPool<int> pool = longAndShort();
  pool.addRow(std::vector<int>{7, 8});
  pool.addRow({});
  EXPECT_EQ(rowsOf(pool), (Rows{{}, {1}, std::vector<int>(1000, 2), {7, 8}, {}}));
  EXPECT_FALSE(pool.wasteful());
}

TEST(RowPool, ReservedRoomKeepsRowsWhereTheyAre) {
  RowPool<int> pool;
  pool.reserve(100, 1000);
  const std::vector<int> row(10, 7);
  pool.addRow(row);
  const int* const first = pool[0].data();
  for (int n = 1; n < 100; ++n) pool.addRow(row);
  EXPECT_EQ(pool[0].data(), first);
  EXPECT_EQ(rowsOf(pool), Rows(100, row));
}

TEST(RowPool, GivesRowsRoomWithoutChangingThem) {
  RowPool<int> pool = longAndShort();
  const Rows before = rowsOf(pool);
  pool.spread([](std::size_t k) { return static_cast<std::uint32_t>(2 * k); });
  EXPECT_EQ(rowsOf(pool), before);
  const int* const first = pool[1].data();
  for (const int element : {5, 6}) pool.append(1, element, 0);
  EXPECT_EQ(rowsOf(pool)[1], (std::vector<int>{1, 5, 6}));
  EXPECT_EQ(pool[1].data(), first) << "there was room for two";
  EXPECT_EQ(rowsOf(pool)[2], before[2]);
}

TEST(RowPool, SetsARowInPlaceOnlyWhereThereIsRoom) {
  RowPool<int> pool = longAndShort();
  pool.append(1, 7, 2);  // which gives it room for two more
  const Rows before = rowsOf(pool);
  EXPECT_FALSE(pool.setInPlace(1, std::vector<int>(5, 9)));
  EXPECT_FALSE(pool.setInPlace(2, std::vector<int>(700, 9))) << "more room to spare than a row may have";
  EXPECT_EQ(rowsOf(pool), before);
  EXPECT_TRUE(pool.setInPlace(1, std::vector<int>(4, 9)));
  EXPECT_TRUE(pool.setInPlace(2, std::vector<int>(800, 8)));
  EXPECT_EQ(rowsOf(pool), (Rows{{}, std::vector<int>(4, 9), std::vector<int>(800, 8)}));
  EXPECT_TRUE(pool.setInPlace(1, {}));
  EXPECT_TRUE(pool.setInPlace(1, std::vector<int>(4, 6)));
  EXPECT_EQ(rowsOf(pool)[1], std::vector<int>(4, 6));
}

TEST(RowPool, HoldsWhatRowsWereGiven) {
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  const auto below = [&](std::size_t limit) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(limit));
  };
  RowPool<int> pool;
  Rows expected;
  bool everWasteful = false;
  for (int step = 0; step < 20000; ++step) {
    if (step % 200 == 0) {
      expected.resize(expected.size() + 3);
      pool.resize(expected.size());
    }
    const std::size_t row = below(expected.size());
    std::vector<int>& wanted = expected[row];
    switch (below(4)) {
      case 0:
        wanted = std::vector<int>(below(step % 500 == 0 ? 2000 : 12), step);
        pool.set(row, wanted, 2);
        break;
      case 1:
        wanted.resize(below(wanted.size() + 1));
        pool.shorten(row, wanted.size());
        break;
      default:
        wanted.push_back(step);
        pool.append(row, step, 3);
    }
    if (pool.wasteful()) {
      everWasteful = true;
      pool.compact(static_cast<std::uint32_t>(step % 3));
      EXPECT_FALSE(pool.wasteful());
      ASSERT_EQ(rowsOf(pool), expected) << "after step " << step;
    }
  }
  EXPECT_TRUE(everWasteful);
  EXPECT_EQ(rowsOf(pool), expected);
}

TEST(RowPool, ARowThatShrinksFarLeavesNoMoreThanItMayHaveSpare) {
  RowPool<int> pool = longAndShort();
  pool.shorten(2, 1);
  EXPECT_TRUE(pool.wasteful()) << "most of a thousand places";
  pool.set(2, std::vector<int>(RowPool<int>::mostSpare + 2, 7), 0);
  EXPECT_EQ(rowsOf(pool)[2], std::vector<int>(RowPool<int>::mostSpare + 2, 7));
}

TEST(RowPool, LaidOutAnewHasNothingOfBefore) {
  RowPool<int> pool = longAndShort();
  pool.shorten(2, 1);
  pool.layOut(2, [](std::size_t) { return 1; });
  EXPECT_FALSE(pool.wasteful());
  EXPECT_EQ(pool.size(), 2U);
  EXPECT_EQ(pool.elementCount(), 2U);
}

TEST(RowPool, ComesBackFromAnArchive) {
  RowPool<int> pool = longAndShort();
  pool.append(0, 9, 3);
  WritingArchive writing;
  writing(pool);
  RowPool<int> read;
  ReadingArchive reading(writing.buffer());
  reading(read);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_EQ(rowsOf(read), rowsOf(pool));
  read.append(0, 8, 3);
  EXPECT_EQ(rowsOf(read)[0], (std::vector<int>{9, 8}));
}

TEST(RowPool, RefusesRowsThatItCannotTellApart) {
  RowPool<char> pool;
  EXPECT_THROW(pool.layOut(1, [](std::size_t) { return std::size_t{1} << 24; }), std::length_error);
  EXPECT_THROW(pool.layOut(300, [](std::size_t) { return (std::size_t{1} << 24) - 1; }), std::length_error);
}

}  // namespace
}  // namespace restenosis
