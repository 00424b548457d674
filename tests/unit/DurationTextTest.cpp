#include <gtest/gtest.h>

#include "bridge/output/DurationText.h"

namespace restenosis {
namespace {

TEST(DurationText, IsInSecondsMinutesOrHours) {
  EXPECT_EQ(durationText(0.4), "0 s");
  EXPECT_EQ(durationText(59.4), "59 s");
  EXPECT_EQ(durationText(59.6), "1 min 00 s");
  EXPECT_EQ(durationText(425), "7 min 05 s");
  EXPECT_EQ(durationText(12000), "3 h 20 min");
  EXPECT_EQ(durationText(360000), "100 h 00 min");
}

}  // namespace
}  // namespace restenosis
