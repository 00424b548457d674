#include <gtest/gtest.h>

#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

TEST(Trimmed, TakesBlanksFromBothEndsOnly) {
  EXPECT_EQ(trimmed(" \t1.2 mm\t "), "1.2 mm");
  EXPECT_EQ(trimmed("word"), "word");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
  EXPECT_EQ(trimmed("\rword\r"), "\rword\r");
}

TEST(Trimmed, BlanksCanBeOthers) { EXPECT_EQ(trimmed("\"a b\"\r", "\"\r"), "a b"); }

}  // namespace
}  // namespace restenosis
