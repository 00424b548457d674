#include <gtest/gtest.h>

#include <string>

#include "tissue/parameters/Limit.h"

namespace restenosis {
namespace {

TEST(Limit, IsReachedByWhatIsTheSameToRounding) {
  const double room = 0.15e-3 - 2 * 15e-6;  // a little less than 120e-6
  EXPECT_FALSE(exceeds(120e-6, room));
  EXPECT_FALSE(exceeds(3 * 0.05e-3, 0.15e-3));
  EXPECT_TRUE(exceeds(120.001e-6, room));
  EXPECT_TRUE(exceeds(1e-12, 0));
}

TEST(Limit, IsShownSuchThatWhatIsShownIsAllowed) {
  for (const double limit : {61.0 / 6, 120.0, 0.15, 1.8, 12345.678, 0.1 + 0.2, 99999.95, 2.0 / 3, 1e-3}) {
    EXPECT_FALSE(exceeds(std::stod(shownAtMost(limit)), limit)) << limit;
    EXPECT_FALSE(exceeds(limit, std::stod(shownAtLeast(limit)))) << limit;
    EXPECT_NEAR(std::stod(shownAtMost(limit)), limit, 1e-5 * limit);
    EXPECT_NEAR(std::stod(shownAtLeast(limit)), limit, 1e-5 * limit);
  }
  EXPECT_EQ(shownAtMost(61.0 / 6), "10.1666");
  EXPECT_EQ(shownAtLeast(61.0 / 6), "10.1667");
  EXPECT_EQ(shownAtMost(-61.0 / 6), "-10.1667");
  EXPECT_EQ(shownAtLeast(-61.0 / 6), "-10.1666");
  EXPECT_EQ(shownAtMost(0), "0");
  EXPECT_EQ(shownAtMost(170), "170");
  EXPECT_EQ(shownAtLeast(0.15), "0.15");
}

}  // namespace
}  // namespace restenosis
