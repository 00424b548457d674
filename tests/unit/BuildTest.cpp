#include <gtest/gtest.h>

#include "bridge/output/Build.h"
#include "bridge/output/Version.h"

namespace restenosis {
namespace {

TEST(Build, IsTheSameAsItself) {
  const auto traits = buildTraits();
  EXPECT_EQ(traits.at("version"), version());
  for (const char* name : {"compiler", "instructions", "processor"}) EXPECT_NE(traits.at(name), "") << name;
  EXPECT_EQ(traitsInPlace(traits, buildTraits()), "");
}

TEST(Build, SaysWhatIsInPlaceOfWhat) {
  EXPECT_EQ(traitsInPlace({{"a", "1"}, {"b", "2"}}, {{"b", "3"}, {"c", "4"}}),
            "a none (before: 1), b 3 (before: 2), c 4 (before: none)");
}

}  // namespace
}  // namespace restenosis
