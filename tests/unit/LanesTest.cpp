#include <gtest/gtest.h>

#include <array>

#include "Lanes.h"

namespace restenosis {
namespace {

/// Transposes a table of `lanes` rows of eight that are not next to each other in memory.
template <int lanes>
void expectColumns() {
  std::array<std::array<float, 11>, lanes> table;
  for (int k = 0; k < lanes; ++k)
    for (int n = 0; n < 11; ++n) table[k][n] = static_cast<float>(100 * k + n);
  std::array<Numbers<float, lanes>, 8> columns;
  transpose<float>([&](int k) { return table[k].data(); }, columns);
  for (int n = 0; n < 8; ++n)
    for (int k = 0; k < lanes; ++k) EXPECT_EQ(columns[n][k], table[k][n]) << "row " << k << ", column " << n;
}

TEST(Lanes, TransposeTablesOfAnyHeight) {
  expectColumns<4>();
  expectColumns<8>();
  expectColumns<16>();
}

TEST(Lanes, JoinVectorsOfEightInTheirOrder) {
  using Eight = Numbers<float, 8>::Vector;
  const Eight first{0, 1, 2, 3, 4, 5, 6, 7}, second{8, 9, 10, 11, 12, 13, 14, 15};
  const auto one = joined(std::array{first});
  for (int k = 0; k < 8; ++k) EXPECT_EQ(one[k], static_cast<float>(k));
  const auto both = joined(std::array{first, second});
  for (int k = 0; k < 16; ++k) EXPECT_EQ(both[k], static_cast<float>(k));
}

}  // namespace
}  // namespace restenosis
