#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/coupling/AlikeRemarks.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

TEST(AlikeRemarks, TheFirstStayAndTheLastWithTheirNumber) {
  std::vector<std::string> remarks = {"of another part"};
  AlikeRemarks alike;
  for (int day = 1; day <= 4; ++day)
    alike.add(remarks, fmt::format("day {}: ", day), fmt::format("{:.1f} um wide", 10.0 / day));
  EXPECT_EQ(remarks, (std::vector<std::string>{"of another part", "day 1: 10.0 um wide", "day 2: 5.0 um wide",
                                               "day 3: 3.3 um wide", "day 4: 2.5 um wide"}));
  alike.add(remarks, "day 5: ", "bent");
  for (int day = 6; day <= 9; ++day) alike.add(remarks, fmt::format("day {}: ", day), "-1.5e-3 um wide");
  for (int day = 6; day <= 7; ++day) alike.add(remarks, fmt::format("day {}: ", day), "2 um wide");
  ASSERT_EQ(remarks.size(), 10u);
  EXPECT_EQ(remarks[4], "day 7: 2 um wide (the last of 6 remarks like this)");
  EXPECT_EQ(remarks[5], "day 5: bent");
}

TEST(AlikeRemarks, AreCountedOnAfterAResumption) {
  std::vector<std::string> remarks;
  AlikeRemarks before, after;
  for (int n = 0; n < 5; ++n) before.add(remarks, "", "said");
  WritingArchive writer;
  before.archive(writer);
  ReadingArchive reader(writer.buffer());
  after.archive(reader);
  after.add(remarks, "", "said");
  ASSERT_EQ(remarks.size(), 4u);
  EXPECT_EQ(remarks.back(), "said (the last of 6 remarks like this)");
}

}  // namespace
}  // namespace restenosis
