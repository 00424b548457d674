#include <gtest/gtest.h>

#include <array>

#include "tissue/agents/Lanes.h"

namespace restenosis {
namespace {

TEST(Lanes, AreReadFromNumbersSideBySide) {
  std::array<float, 9> stored;
  for (int k = 0; k < 9; ++k) stored[k] = 0.5F + static_cast<float>(k);
  const auto eight = Numbers<float, 8>::from(stored.data() + 1);
  for (int k = 0; k < 8; ++k) EXPECT_EQ(eight[k], stored[k + 1]);
  const auto four = Numbers<double, 4>::from(stored.data() + 2);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(four[k], stored[k + 2]);
}

TEST(Lanes, AreStoredAddedAndCompared) {
  const std::array<double, 4> stored{3, -1, 7, 2};
  const auto four = Numbers<double, 4>::from(stored.data());
  std::array<double, 6> copy{};
  four.store(copy.data() + 1);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(copy[k + 1], stored[k]);
  EXPECT_EQ(copy[0], 0);
  EXPECT_EQ(copy[5], 0);
  EXPECT_EQ(four.sum(), 11);
  EXPECT_EQ(four.smallest(), -1);
}

TEST(Lanes, JoinVectorsOfEightInTheirOrder) {
  using Eight = Numbers<float, 8>::Vector;
  const Eight first{0, 1, 2, 3, 4, 5, 6, 7}, second{8, 9, 10, 11, 12, 13, 14, 15};
  const auto one = joined(std::array{first});
  for (int k = 0; k < 8; ++k) EXPECT_EQ(one[k], static_cast<float>(k));
  const auto both = joined(std::array{first, second});
  for (int k = 0; k < 16; ++k) EXPECT_EQ(both[k], static_cast<float>(k));
}

TEST(Lanes, TellWhichElementsOfAMaskAreSet) {
  using Eight = Numbers<double, 8>;
  for (unsigned bits = 0; bits < 256; ++bits) {
    std::array<double, 8> values{};
    for (unsigned k = 0; k < 8; ++k) values[k] = (bits >> k & 1U) != 0 ? 1 : 3;
    EXPECT_EQ(bitsOf(Eight::from(values.data()) <= Eight(1)), bits);
  }
}

}  // namespace
}  // namespace restenosis
